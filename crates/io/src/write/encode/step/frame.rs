//! The header of a file, and the instances that every shape needs: product, definition, units, uncertainty.

use super::{Head, Id, List, Real, Step, StepProtocol, Text};
use crate::unit::Unit;
use std::io::{self, Write};

/// The name of a schema with its object identifier; the application, its protocol and the year of it.
fn schema(protocol: StepProtocol) -> (&'static str, &'static str, &'static str, u16) {
    match protocol {
        StepProtocol::Ap242 => (
            "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }",
            "managed model based 3d engineering",
            "ap242_managed_model_based_3d_engineering",
            2014,
        ),
        StepProtocol::Ap214 => (
            "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }",
            "core data for automotive mechanical design processes",
            "automotive_design",
            2000,
        ),
    }
}

pub(super) fn header(out: &mut dyn Write, head: &Head) -> io::Result<()> {
    let program = format!("lineament {}", head.version);
    let (name, program) = (Text(head.name), Text(&program));
    writeln!(out, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('feature lines and faces of a scan'),'2;1');")?;
    // The time is no part of a result: the same input gives the same bytes.
    writeln!(out, "FILE_NAME({name},'1970-01-01T00:00:00',(''),(''),{program},{program},'');")?;
    writeln!(out, "FILE_SCHEMA(('{}'));\nENDSEC;\nDATA;", schema(head.protocol).0)
}

/// The product with a definition that waits for its shape, and the context of representations.
pub(super) fn product(step: &mut Step, head: &Head) -> io::Result<()> {
    let (_, application, protocol, year) = schema(head.protocol);
    let name = Text(head.name);
    let context = step.add(format_args!("APPLICATION_CONTEXT('{application}')"))?;
    step.add(format_args!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','{protocol}',{year},#{context})"
    ))?;
    let of_product = step.add(format_args!("PRODUCT_CONTEXT('',#{context},'mechanical')"))?;
    let product = step.add(format_args!("PRODUCT({name},{name},'',(#{of_product}))"))?;
    step.add(format_args!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#{product}))"))?;
    let formation = step.add(format_args!("PRODUCT_DEFINITION_FORMATION('','',#{product})"))?;
    let of_definition =
        step.add(format_args!("PRODUCT_DEFINITION_CONTEXT('part definition',#{context},'design')"))?;
    let definition =
        step.add(format_args!("PRODUCT_DEFINITION('design','',#{formation},#{of_definition})"))?;
    step.shape = step.add(format_args!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"))?;
    let length = length(step, head.unit.unwrap_or(Unit::Millimetre))?;
    let angle = step.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")?;
    let solid = step.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")?;
    let uncertainty = step.add(format_args!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),#{length},'distance_accuracy_value','greatest gap')",
        Real(head.uncertainty)
    ))?;
    step.context = step.add(format_args!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{uncertainty}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid}))REPRESENTATION_CONTEXT('','3D'))"
    ))?;
    Ok(())
}

/// The unit of length: one of the SI, or one made of it.
fn length(step: &mut Step, unit: Unit) -> io::Result<Id> {
    let si = |prefix: &str| format!("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.))");
    let (name, millimetres) = match unit {
        Unit::Millimetre => return step.add(si(".MILLI.")),
        Unit::Centimetre => return step.add(si(".CENTI.")),
        Unit::Metre => return step.add(si("$")),
        Unit::Inch => ("INCH", 25.4),
        Unit::Foot => ("FOOT", 304.8),
        Unit::SurveyFoot => ("US SURVEY FOOT", 1e3 * unit.metres()),
    };
    let millimetre = step.add(si(".MILLI."))?;
    let factor = step
        .add(format_args!("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),#{millimetre})", Real(millimetres)))?;
    let dimensions = step.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")?;
    step.add(format_args!(
        "(CONVERSION_BASED_UNIT('{name}',#{factor})LENGTH_UNIT()NAMED_UNIT(#{dimensions}))"
    ))
}

/// Gives the product its shape: one representation, or several that a common one leads to.
pub(super) fn shapes(step: &mut Step, representations: &[Id]) -> io::Result<()> {
    let shape = step.shape;
    let root = match *representations {
        [one] => one,
        ref all => {
            let context = step.context;
            let place = step.placement([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])?;
            let root = step.add(format_args!("SHAPE_REPRESENTATION('',{},#{context})", List(&[place])))?;
            for other in all {
                step.add(format_args!("SHAPE_REPRESENTATION_RELATIONSHIP('','',#{root},#{other})"))?;
            }
            root
        }
    };
    step.add(format_args!("SHAPE_DEFINITION_REPRESENTATION(#{shape},#{root})"))?;
    Ok(())
}

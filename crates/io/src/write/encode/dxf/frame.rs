//! What stands around the entities: header, tables, blocks, and the dictionaries and layouts after them, as release 2000 requires
//! them. Their handles lie below those of layers and entities.

use super::Layer;
use super::group::{Groups, Handles};
use crate::unit::Unit;
use std::io;

/// Handles of the blocks of model space and paper space.
pub(super) const MODEL_SPACE: usize = 0x20;
const PAPER_SPACE: usize = 0x21;
/// Handles of the table of layers, and of the plot style that layers name.
const LAYERS: usize = 0x2;
const PLOT_STYLE: usize = 0x34;
/// Handles of dictionaries: the root, groups, layouts, plot styles; and of the layouts.
const ROOT: usize = 0x30;
const GROUPS: usize = 0x31;
const LAYOUTS: usize = 0x32;
const PLOT_STYLES: usize = 0x33;
const MODEL_LAYOUT: usize = 0x35;
const PAPER_LAYOUT: usize = 0x36;
/// Height of the view of a drawing without extent, and room around one with extent.
const HEIGHT: f64 = 100.0;
const ROOM: f64 = 1.1;

type Extent = Option<[[f64; 3]; 2]>;

/// The header. `seed` is the first handle that the file leaves free.
pub(super) fn header(out: &mut Groups, unit: Option<Unit>, extent: Extent, seed: usize) -> io::Result<()> {
    out.text("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\nANSI_1252\n9\n$HANDSEED\n")?;
    out.handle(5, seed)?;
    out.text("9\n$INSUNITS\n")?;
    out.put(70, unit.map_or(0, Unit::dxf))?;
    out.text("9\n$MEASUREMENT\n")?;
    out.put(70, u8::from(unit.is_none_or(Unit::is_metric)))?;
    if let Some([low, high]) = extent {
        out.text("9\n$EXTMIN\n")?;
        out.place(10, low)?;
        out.text("9\n$EXTMAX\n")?;
        out.place(10, high)?;
    }
    out.text("0\nENDSEC\n")
}

/// Tables and blocks, and the beginning of the entities.
pub(super) fn tables(
    out: &mut Groups,
    layers: &[Layer],
    extent: Extent,
    handles: &mut Handles,
) -> io::Result<()> {
    out.text("0\nSECTION\n2\nTABLES\n")?;
    table(out, "VPORT", 0x8, 1)?;
    view(out, extent)?;
    table(out, "LTYPE", 0x5, 3)?;
    for (handle, name) in [(0x11, "ByBlock"), (0x12, "ByLayer"), (0x13, "Continuous")] {
        record(out, "LTYPE", "Linetype", [handle, 0x5], name)?;
        out.text("70\n0\n3\n\n72\n65\n73\n0\n40\n0.0\n")?;
    }
    table(out, "LAYER", LAYERS, layers.len() + 1)?;
    layer(out, 0x14, "0", 7)?;
    layers.iter().try_for_each(|(name, colour)| layer(out, handles.next(), name, *colour))?;
    table(out, "STYLE", 0x3, 1)?;
    record(out, "STYLE", "TextStyle", [0x15, 0x3], "Standard")?;
    out.text("70\n0\n40\n0.0\n41\n1.0\n50\n0.0\n71\n0\n42\n2.5\n3\ntxt\n4\n\n")?;
    table(out, "VIEW", 0x6, 0)?;
    table(out, "UCS", 0x7, 0)?;
    table(out, "APPID", 0x9, 1)?;
    record(out, "APPID", "RegApp", [0x16, 0x9], "ACAD")?;
    out.text("70\n0\n")?;
    table(out, "DIMSTYLE", 0xA, 1)?;
    out.text("100\nAcDbDimStyleTable\n0\nDIMSTYLE\n105\n17\n330\nA\n100\nAcDbSymbolTableRecord\n")?;
    out.text("100\nAcDbDimStyleTableRecord\n2\nStandard\n70\n0\n")?;
    table(out, "BLOCK_RECORD", 0x1, 2)?;
    for (handle, name, layout) in
        [(MODEL_SPACE, "*Model_Space", MODEL_LAYOUT), (PAPER_SPACE, "*Paper_Space", PAPER_LAYOUT)]
    {
        record(out, "BLOCK_RECORD", "Block", [handle, 0x1], name)?;
        out.handle(340, layout)?;
    }
    out.text("0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n")?;
    block(out, "*Model_Space", MODEL_SPACE, 0x22)?;
    block(out, "*Paper_Space", PAPER_SPACE, 0x24)?;
    out.text("0\nENDSEC\n0\nSECTION\n2\nENTITIES\n")
}

/// The end of the entities, the objects, and the end of the file.
pub(super) fn objects(out: &mut Groups) -> io::Result<()> {
    out.text("0\nENDSEC\n0\nSECTION\n2\nOBJECTS\n")?;
    let entries = [("ACAD_GROUP", GROUPS), ("ACAD_LAYOUT", LAYOUTS), ("ACAD_PLOTSTYLENAME", PLOT_STYLES)];
    dictionary(out, "DICTIONARY", [ROOT, 0], &entries)?;
    dictionary(out, "DICTIONARY", [GROUPS, ROOT], &[])?;
    let layouts = [("Model", MODEL_LAYOUT), ("Layout1", PAPER_LAYOUT)];
    dictionary(out, "DICTIONARY", [LAYOUTS, ROOT], &layouts)?;
    dictionary(out, "ACDBDICTIONARYWDFLT", [PLOT_STYLES, ROOT], &[("Normal", PLOT_STYLE)])?;
    out.text("100\nAcDbDictionaryWithDefault\n")?;
    out.handle(340, PLOT_STYLE)?;
    out.text("0\nACDBPLACEHOLDER\n")?;
    out.handle(5, PLOT_STYLE)?;
    out.handle(330, PLOT_STYLES)?;
    layout(out, MODEL_LAYOUT, ("Model", 0), MODEL_SPACE)?;
    layout(out, PAPER_LAYOUT, ("Layout1", 1), PAPER_SPACE)?;
    out.text("0\nENDSEC\n0\nEOF\n")
}

/// The head of a table, after the end of the one before.
fn table(out: &mut Groups, name: &str, handle: usize, entries: usize) -> io::Result<()> {
    if name != "VPORT" {
        out.text("0\nENDTAB\n")?;
    }
    out.put(0, "TABLE")?;
    out.put(2, name)?;
    out.handle(5, handle)?;
    out.text("330\n0\n100\nAcDbSymbolTable\n")?;
    out.put(70, entries)
}

/// The head of an entry of a table, with its handle and that of the table.
fn record(out: &mut Groups, kind: &str, class: &str, [own, owner]: [usize; 2], name: &str) -> io::Result<()> {
    out.put(0, kind)?;
    out.handle(5, own)?;
    out.handle(330, owner)?;
    out.text("100\nAcDbSymbolTableRecord\n")?;
    out.put(100, format_args!("AcDb{class}TableRecord"))?;
    out.put(2, name)
}

fn layer(out: &mut Groups, handle: usize, name: &str, colour: u8) -> io::Result<()> {
    record(out, "LAYER", "Layer", [handle, LAYERS], name)?;
    out.put(70, 0)?;
    out.put(62, colour)?;
    out.put(6, "Continuous")?;
    out.put(370, -3)?;
    out.handle(390, PLOT_STYLE)
}

/// The view that a program shows first: all of the drawing from above.
fn view(out: &mut Groups, extent: Extent) -> io::Result<()> {
    let [low, high] = extent.unwrap_or([[0.0; 3], [HEIGHT; 3]]);
    let middle = [0, 1].map(|k| 0.5 * (low[k] + high[k]));
    let height = f64::max(high[1] - low[1], (high[0] - low[0]) / ROOM);
    record(out, "VPORT", "Viewport", [0x10, 0x8], "*Active")?;
    out.text("70\n0\n10\n0.0\n20\n0.0\n11\n1.0\n21\n1.0\n")?;
    out.place(12, middle)?;
    out.text("13\n0.0\n23\n0.0\n14\n0.5\n24\n0.5\n15\n0.5\n25\n0.5\n16\n0.0\n26\n0.0\n36\n1.0\n17\n0.0\n27\n0.0\n37\n0.0\n")?;
    out.real(40, if height > 0.0 { ROOM * height } else { HEIGHT })?;
    out.text("41\n1.34\n42\n50.0\n43\n0.0\n44\n0.0\n50\n0.0\n51\n0.0\n71\n0\n72\n1000\n73\n1\n74\n3\n75\n0\n76\n0\n77\n0\n78\n0\n")
}

/// A block without entities of its own; `first` is its handle, its end has the next.
fn block(out: &mut Groups, name: &str, owner: usize, first: usize) -> io::Result<()> {
    out.put(0, "BLOCK")?;
    out.handle(5, first)?;
    out.handle(330, owner)?;
    out.text("100\nAcDbEntity\n8\n0\n100\nAcDbBlockBegin\n")?;
    out.put(2, name)?;
    out.text("70\n0\n10\n0.0\n20\n0.0\n30\n0.0\n")?;
    out.put(3, name)?;
    out.text("1\n\n0\nENDBLK\n")?;
    out.handle(5, first + 1)?;
    out.handle(330, owner)?;
    out.text("100\nAcDbEntity\n8\n0\n100\nAcDbBlockEnd\n")
}

/// A dictionary with its handle and that of its owner, and the names and handles of its entries.
fn dictionary(
    out: &mut Groups,
    kind: &str,
    [own, owner]: [usize; 2],
    entries: &[(&str, usize)],
) -> io::Result<()> {
    out.put(0, kind)?;
    out.handle(5, own)?;
    out.handle(330, owner)?;
    out.text("100\nAcDbDictionary\n281\n1\n")?;
    entries.iter().try_for_each(|(name, handle)| {
        out.put(3, name)?;
        out.handle(350, *handle)
    })
}

/// A layout of a block: its name and its place among the tabs.
fn layout(out: &mut Groups, handle: usize, (name, tab): (&str, u8), block: usize) -> io::Result<()> {
    out.put(0, "LAYOUT")?;
    out.handle(5, handle)?;
    out.handle(330, LAYOUTS)?;
    out.text("100\nAcDbPlotSettings\n1\n\n2\n\n4\n\n6\n\n40\n0.0\n41\n0.0\n42\n0.0\n43\n0.0\n44\n420.0\n45\n297.0\n46\n0.0\n47\n0.0\n")?;
    out.text("48\n0.0\n49\n0.0\n140\n0.0\n141\n0.0\n142\n1.0\n143\n1.0\n")?;
    // Plots in model space are of the model.
    out.put(70, if tab == 0 { 1024 } else { 0 })?;
    out.text("72\n1\n73\n0\n74\n5\n7\n\n75\n16\n147\n1.0\n148\n0.0\n149\n0.0\n100\nAcDbLayout\n")?;
    out.put(1, name)?;
    out.put(70, 1)?;
    out.put(71, tab)?;
    out.text("10\n0.0\n20\n0.0\n11\n420.0\n21\n297.0\n12\n0.0\n22\n0.0\n32\n0.0\n14\n0.0\n24\n0.0\n34\n0.0\n15\n420.0\n25\n297.0\n35\n0.0\n")?;
    out.text(
        "146\n0.0\n13\n0.0\n23\n0.0\n33\n0.0\n16\n1.0\n26\n0.0\n36\n0.0\n17\n0.0\n27\n1.0\n37\n0.0\n76\n0\n",
    )?;
    out.handle(330, block)
}

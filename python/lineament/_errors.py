"""Exceptions of the package. Their texts are those of the program."""

from __future__ import annotations


class LineamentError(Exception):
    """Base of all exceptions that the package raises of itself."""


class ParameterError(LineamentError, ValueError):
    """A parameter is unknown or out of range. The text names it, its value, and the values accepted."""


class CloudError(LineamentError, ValueError):
    """The points have no surface to find lines on, or exceed the limits: too few, collinear, too far apart, too many."""


class InputError(LineamentError, OSError, ValueError):
    """A file cannot be read, or is malformed. The text names file, place, value and a remedy."""


class InputNotFoundError(InputError, FileNotFoundError):
    """A file to read is not there."""


class OutputError(LineamentError, OSError, ValueError):
    """A file cannot be written. Nothing is left half-written."""


class InternalError(LineamentError, RuntimeError):
    """An error of lineament itself. Please report it with its text."""

# SPDX-License-Identifier: Apache-2.0
"""What riprap raises. The exit codes of the command line have the same meanings."""
from typing import NamedTuple


class Problem(NamedTuple):
    """One problem with a case: where, what was read, what is allowed. Lines and columns count from 1; 0 = unknown."""

    file: str
    line: int
    column: int
    message: str
    allowed: str

    def __str__(self):
        place = ":".join([self.file] + [str(n) for n in (self.line, self.column) if n > 0])
        return f"{place}: {self.message}" + (f"; {self.allowed}" if self.allowed else "")


class Error(Exception):
    """All errors of riprap."""


class CaseError(Error, ValueError):
    """The case or a file that it reads is wrong. `problems` lists everything that was found (tuple of Problem)."""

    def __init__(self, problems):
        self.problems = tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))

    def __reduce__(self):  # args hold the text, not the problems
        return type(self), (self.problems,)


class FileError(Error, OSError):
    """A file or folder cannot be read or written."""


class CheckpointError(Error):
    """A checkpoint is truncated, damaged or of another case."""


class NumericalError(Error, ArithmeticError):
    """A step was refused: its numbers are not finite or absurd, or the energy ledger does not close. The State is the
    last good one."""


class InternalError(Error):
    """A bug in riprap."""

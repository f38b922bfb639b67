# SPDX-License-Identifier: BSD-3-Clause
"""Runs VTK algorithms. Their errors become exceptions, their warnings become Python warnings; nothing is printed."""
import warnings

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


class Listener:
    """Collects the texts of errors and warnings of VTK objects, even if VTK is set to show none."""

    def __init__(self, *objects):
        self._shows = vtkObject.GetGlobalWarningDisplay()
        vtkObject.GlobalWarningDisplayOn()      # without this, VTK sends no events
        self.errors, self.warnings = [], []
        self._observed = []
        for one in objects:
            for event, texts in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
                self._observed.append((one, one.AddObserver(event, self._take(texts))))

    @staticmethod
    def _take(texts):
        def take(caller, event, text):
            if not caller.IsA("vtkExecutive"):      # the error of an executive only repeats the error of its algorithm
                texts.append(words(text or "what is wrong cannot be shown: its words are not UTF-8"))
        take.CallDataType = "string0"
        return take

    def stop(self):
        for one, tag in self._observed:
            one.RemoveObserver(tag)
        vtkObject.SetGlobalWarningDisplay(self._shows)


def words(text):
    """Returns the message in VTK's text "ERROR: In file.cxx, line 1\\nvtkClass (0x1234): message\\n\\n"."""
    return text.partition("): ")[2].strip() or text.strip()


def run(algorithm, kind=ValueError, others=(), progress=None, expected=None):
    """Updates an algorithm. Its errors and those of `others` are raised as `kind`; warnings become Python warnings.

    Warnings that contain the text `expected` are omitted. `progress` is called with the completed fraction, 0 to 1. If
    `progress` raises an exception, the algorithm is aborted and the exception is raised again."""
    listener = Listener(algorithm, algorithm.GetExecutive(), *others)
    raised = []

    def show(caller, event):
        try:
            progress(caller.GetProgress())
        except BaseException as exception:             # VTK would print the exception and continue
            raised.append(exception)
            caller.SetAbortExecute(1)

    tag = None if progress is None else algorithm.AddObserver("ProgressEvent", show)
    try:
        algorithm.Update()
    finally:
        listener.stop()
        if tag is not None:
            algorithm.RemoveObserver(tag)
            algorithm.SetAbortExecute(0)
    if raised:
        raise raised[0]
    if listener.errors:
        raise kind(listener.errors[0])
    for text in listener.warnings:
        if expected is not None and expected in text:
            continue
        warnings.warn(text, RuntimeWarning, stacklevel=3)
    return algorithm


def output_of(source):
    """Updates a vtkAlgorithm or one of its output ports, and returns the output data."""
    if isinstance(source, vtkAlgorithm):
        return run(source, RuntimeError).GetOutputDataObject(0)
    run(source.GetProducer(), RuntimeError)
    return source.GetProducer().GetOutputDataObject(source.GetIndex())

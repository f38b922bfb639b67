# SPDX-License-Identifier: BSD-3-Clause
"""Checks whether VTK reads its own XML with raw binary data on this machine. ParaView passes such data between
processes. VTK before 9.3.1 fails with expat since 2.6, and with Debian's patched 2.5 (VTK's issue 19258), at most
lengths of the header."""
import sys
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkObject
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter


def reads_itself(data):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.WriteToOutputStringOn()
    writer.Write()
    reader = vtkXMLPolyDataReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(writer.GetOutputString())
    reader.Update()
    return reader.GetOutput().GetNumberOfPoints() == data.GetNumberOfPoints()


def need_raw_xml():
    sphere = vtkSphereSource()
    sphere.Update()
    data = vtkPolyData()
    data.ShallowCopy(sphere.GetOutput())
    vtkObject.GlobalWarningDisplayOff()
    whole = True
    for number in range(10):
        array = vtkFloatArray()
        array.SetName("Array" * (1 + number))
        array.SetNumberOfTuples(data.GetNumberOfPoints())
        data.GetPointData().AddArray(array)
        whole = whole and reads_itself(data)
    vtkObject.GlobalWarningDisplayOn()
    if not whole:
        print("ParaView cannot pass data between processes with this system's expat (VTK's issue 19258)")
        sys.exit(77)

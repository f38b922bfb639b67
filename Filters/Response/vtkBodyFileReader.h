// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBodyFileReader
 * @brief   reads a body or a scan from any kind of file that Palpate knows, and never crashes on a
 *   file
 *
 * Output: the content of the file. The end of the name determines the kind, in upper or lower case:
 * - `.stl` (ASCII or binary), `.obj`, `.ply`, `.vtp`: a vtkPolyData. Corners of an `.stl` at the
 *   same place become one point. Each vertex of an `.obj` is one point, whatever its texture
 *   coordinates; its normals are kept if each point has a single normal;
 * - `.vtu`: a vtkUnstructuredGrid; `.vtk`: any of VTK's data sets; `.vti`: a vtkImageData;
 * - `.nii`, `.nii.gz`: a vtkImageData in millimetres, with the header applied. A value is scl_slope
 *   times the stored value, plus scl_inter. Points are placed by the sform, otherwise by the qform
 *   (+x right, +y anterior, +z superior), from m, mm or um. Without either the origin is the first
 *   voxel. The image's direction matrix turns the grid; vtkSkinSurface, vtkLayerThickness and
 *   vtkScannedMaterial use that matrix.
 *
 * Pass the output to vtkBodySurface. Pass a scan to vtkSkinSurface, vtkLayerThickness and
 * vtkScannedMaterial.
 *
 * Errors name the file and, if known, the line, facet, row or header entry. These are errors: a
 * file that is missing, empty, truncated, damaged or of an unknown kind, and a NIfTI scan with
 * several images. Files that VTK reads are read twice, first in a copy of the process. If a reader
 * of VTK crashes there, the file is reported as an error. Read files while no other thread uses
 * VTK.
 *
 * A file that has changed is read again after Modified().
 *
 * @code{.py}
 * reader = palpate.vtkBodyFileReader()
 * reader.SetFileName("liver.stl")
 * reader.Update()
 * if reader.GetFault():                                # "" if the file was read
 *     print(reader.GetFault())
 * body = reader.GetOutput()
 * @endcode
 *
 * @sa
 * vtkBodySurface vtkSkinSurface vtkLayerThickness vtkScannedMaterial
 */

#ifndef vtkBodyFileReader_h
#define vtkBodyFileReader_h

#include "palpateResponseModule.h" // For export macro
#include "vtkDataSetAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string
#include <vector> // For std::vector

class vtkDataSet;

class PALPATERESPONSE_EXPORT vtkBodyFileReader : public vtkDataSetAlgorithm
{
public:
  static vtkBodyFileReader* New();
  vtkTypeMacro(vtkBodyFileReader, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** The file name extensions that can be read, ".vtp .stl ...". */
  static std::string GetFileExtensions();

  /** The error of the last file, without its name; "" if it was read. */
  std::string GetFault() { return this->Fault; }

  ///@{
  /** Changes to the content of the last file. Each note is part of a sentence. */
  int GetNumberOfNotes() { return static_cast<int>(this->Notes.size()); }
  std::string GetNote(int index);
  ///@}

protected:
  vtkBodyFileReader();
  ~vtkBodyFileReader() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /** Reads the file, because its content determines the type of the output. */
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkBodyFileReader(const vtkBodyFileReader&) = delete;
  void operator=(const vtkBodyFileReader&) = delete;

  char* FileName = nullptr;
  std::string Fault;
  std::vector<std::string> Notes;
  vtkSmartPointer<vtkDataSet> Content;
  vtkTimeStamp ReadTime;
};

#endif

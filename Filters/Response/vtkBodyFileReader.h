// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBodyFileReader
 * @brief   reads a body or a scan from any kind of file that Palpate knows, and never crashes on a
 *   file
 *
 * Output: the content of the file. The end of the file name, in upper or lower case, determines the
 * file format:
 * - `.stl` (ASCII or binary), `.obj`, `.ply`, `.vtp`: a vtkPolyData. Corners of an `.stl` at the
 *   same position become one point. Each vertex of an `.obj` is one point, even if it has several
 *   texture coordinates. The normals of an `.obj` are kept if each point has a single normal;
 * - `.vtu`: a vtkUnstructuredGrid; `.vtk`: any of VTK's data sets; `.vti`: a vtkImageData;
 * - `.nii`, `.nii.gz`: a vtkImageData in millimetres, with the header applied. A value is scl_slope
 *   times the stored value, plus scl_inter. The sform, otherwise the qform, gives the coordinates
 *   of the points (+x right, +y anterior, +z superior). The header's unit may be m, mm or um.
 *   Without sform and qform, the origin is the first voxel. The direction matrix of the image
 *   rotates the grid. vtkSkinSurface, vtkLayerThickness and vtkScannedMaterial use this matrix.
 *
 * Pass the output to vtkBodySurface. Pass a scan to vtkSkinSurface, vtkLayerThickness and
 * vtkScannedMaterial.
 *
 * Errors name the file and, if known, the line, facet, row or header entry. These are errors: a
 * file that is missing, empty, truncated, damaged or of an unknown format, and a NIfTI scan with
 * several images. Files that VTK reads are read twice, first in a copy of the process. If a reader
 * of VTK crashes in the copy, the filter reports an error for the file. Read files only while no
 * other thread uses VTK.
 *
 * If the file has changed, call Modified() to read it again.
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
  /** Path of the file. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** Returns the file name extensions that can be read, as the text ".vtp .stl ...". */
  static std::string GetFileExtensions();

  /** Returns the error of the last file, without the name of the file; "" if the file was read. */
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

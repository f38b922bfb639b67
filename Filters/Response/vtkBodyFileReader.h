// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBodyFileReader
 * @brief   reads a file of a body or a scan, of any kind that Palpate knows, and never crashes on
 * it
 *
 * Output: the content of the file. The kind is told by the end of the name, in upper or lower case:
 * - `.stl` (ASCII or binary), `.obj`, `.ply`, `.vtp`: a vtkPolyData. Corners of a `.stl` at the
 * same place become one point. Of an `.obj` each vertex is one point, whatever its texture
 * coordinates; its normals are kept if each point has a single one;
 * - `.vtu`: a vtkUnstructuredGrid; `.vtk`: any of VTK's data sets; `.vti`: a vtkImageData;
 * - `.nii`, `.nii.gz`: a vtkImageData in millimetres, with the header applied: values are scl_slope
 *   times what is stored, plus scl_inter; points are placed by the sform, or else the qform (+x
 *   right, +y anterior, +z superior), from m, mm or um. Without either the origin is the first
 *   voxel. The grid is turned by the direction matrix of the image, which vtkSkinSurface,
 *   vtkLayerThickness and vtkScannedMaterial follow.
 *
 * What comes out goes to vtkBodySurface, or, if it is a scan, to vtkSkinSurface, vtkLayerThickness
 * and vtkScannedMaterial.
 *
 * Errors, each naming the file, and the line, facet, row or entry of the header where it can be
 * told: a file that is missing, empty, truncated or damaged, of an unknown kind, or of a NIfTI scan
 * with several images. Files that VTK reads are read twice, first in a copy of the process: where a
 * reader of VTK's crashes, that is an error. Read while no other thread uses VTK.
 *
 * A file that has changed is read again after Modified().
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

  /** The ends of the names of files that are read, ".vtp .stl ...". */
  static std::string GetFileExtensions();

  /** What is wrong with the last file, without its name; "" if nothing is. */
  std::string GetFault() { return this->Fault; }

  ///@{
  /** What was done to the content of the last file; each note is part of a sentence. */
  int GetNumberOfNotes() { return static_cast<int>(this->Notes.size()); }
  std::string GetNote(int index);
  ///@}

protected:
  vtkBodyFileReader();
  ~vtkBodyFileReader() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /** Reads the file: its content decides on the kind of data. */
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

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBodySurface
 * @brief   converts any surface or volume to triangles in millimetres, a body that can be touched
 *
 * Input: any vtkDataSet, or a composite of them (multi-block, partitioned, collections). Other
 * types of data (tables, graphs, adaptive grids) raise an error that names the filter to apply
 * first. Empty input gives empty output.
 *
 * Output: one vtkPolyData of triangles that wind counter-clockwise seen from outside, in mm:
 * - a surface that consists only of triangles is passed unchanged, with all its arrays, if it is
 *   sound;
 * - the orientation of triangles that wind inward or against their neighbours is reversed,
 *   separately for each connected part (palpate/SoundMesh.h). Stored normals are ignored. An inner
 *   part that winds inward is a cavity;
 * - triangles are left out if they occur twice, if they enclose no volume, as at the seams of
 *   merged scans, or if a coordinate is not finite. Their points remain;
 * - polygons and triangle strips are cut into triangles; vertices and lines are left out;
 * - the outer faces of the three-dimensional cells of a volume (unstructured, structured,
 *   rectilinear, image) are used; cells of lower dimension are left out. The outer faces of an
 *   image are the faces of its box. To get the skin in a scan, use vtkSkinSurface;
 * - partitions of one data set (vtkPartitionedDataSet, vtkMultiPieceDataSet) are joined where their
 *   points coincide exactly, and their ghost cells are left out. All blocks that are volumes are
 *   joined in the same way;
 * - other blocks are appended in their order and are not joined. They must not overlap. A block
 *   without triangles is left out if another block has triangles.
 *
 * Point arrays are kept unchanged, also if they contain lengths. With several blocks or partitions,
 * only arrays that all of them have are kept; a warning names the other arrays. Notes list the
 * changes.
 *
 * **Unit of length.** Coordinates are converted to millimetres with the LengthUnit of the input, or
 * with any LengthScale. If the longest side of the result is below 5 mm or above 5000 mm, a warning
 * asks whether the Length Unit is correct (AskAboutSize).
 *
 * Errors, which name the block if the input has several blocks: a cell refers to a point that does
 * not exist; a cell of a volume is inverted; a polygon cannot be cut; a part is a second body
 * inside another one, or a sheet with two sides (each with its number); the input has no triangles
 * (the error names the filter that makes them from points or lines); LengthScale is not positive.
 *
 * **Several processes** (Controller): each process may have a piece of the body, or none. The
 * errors, the orientation of a closed surface and the size are determined for the whole body. One
 * process issues the warnings. Walls at the seams of a volume are removed. The filter recognises
 * them by ghost cells (it requests one level), by the extent of a structured grid, or as faces that
 * occur twice.
 *
 * Cost: 0.3 s per million triangles. Cells and coordinates of a sound surface in mm are shared with
 * the input.
 *
 * The filter is single-threaded. The output is the same on every run. An abort is ignored.
 *
 * @code{.py}
 * triangles = palpate.vtkBodySurface()
 * triangles.SetInputConnection(reader.GetOutputPort()) # any surface or volume
 * triangles.SetLengthUnitToCentimetre()                # the unit of the input
 * triangles.Update()
 * surface = triangles.GetOutput()                      # triangles, mm
 * @endcode
 *
 * @sa
 * vtkSkinSurface vtkToolContactResponse vtkVoxelBody
 */

#ifndef vtkBodySurface_h
#define vtkBodySurface_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string
#include <vector> // For std::vector

class vtkMultiProcessController;

namespace palpate
{
class Ranks;
}

class PALPATERESPONSE_EXPORT vtkBodySurface : public vtkPolyDataAlgorithm
{
public:
  static vtkBodySurface* New();
  vtkTypeMacro(vtkBodySurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of LengthUnit.
  enum LengthUnitType
  {
    Millimetre = 0,
    Centimetre = 1,
    Metre = 2
  };

  ///@{
  /**
   * The unit of the input's coordinates: Millimetre (default), Centimetre or Metre. GetLengthUnit()
   * returns -1 if LengthScale corresponds to none of these units.
   */
  void SetLengthUnit(int unit);
  int GetLengthUnit();
  void SetLengthUnitToMillimetre() { this->SetLengthUnit(Millimetre); }
  void SetLengthUnitToCentimetre() { this->SetLengthUnit(Centimetre); }
  void SetLengthUnitToMetre() { this->SetLengthUnit(Metre); }
  ///@}

  ///@{
  /**
   * Number of millimetres per unit of the input's coordinates, positive. This is another way to set
   * LengthUnit. Default 1.
   */
  vtkSetMacro(LengthScale, double);
  vtkGetMacro(LengthScale, double);
  ///@}

  ///@{
  /** Whether a warning is issued for a body of implausible size. Default on. */
  vtkSetMacro(AskAboutSize, bool);
  vtkGetMacro(AskAboutSize, bool);
  vtkBooleanMacro(AskAboutSize, bool);
  ///@}

  ///@{
  /**
   * The processes that have pieces of the body. The default is the global controller, if one
   * exists.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** Longest side of the axis-aligned bounding box of the last body, mm; 0 if the body is empty. */
  vtkGetMacro(LongestSide, double);

  /**
   * Returns whether a body with this longest side (mm) probably has another unit of length. This is
   * the case below 5 mm or above 5000 mm.
   */
  static bool IsSizeDoubtful(double longestSide);

  ///@{
  /** Changes to the last input. Each note is part of a sentence. */
  int GetNumberOfNotes() { return static_cast<int>(this->Notes.size()); }
  std::string GetNote(int index);
  ///@}

protected:
  vtkBodySurface();
  ~vtkBodySurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkBodySurface(const vtkBodySurface&) = delete;
  void operator=(const vtkBodySurface&) = delete;

  /**
   * Joins the blocks. `missing` receives the reason why a block has no triangles. Returns "" or an
   * error message.
   */
  std::string Gather(
    vtkInformation* input, vtkPolyData* output, const palpate::Ranks& ranks, std::string& missing);
  /**
   * Reverses the orientation of a closed surface in pieces on several ranks if the surface is
   * inside out.
   */
  void TurnPieces(vtkPolyData* body, const palpate::Ranks& ranks);
  void Scale(vtkPolyData* body);
  void Measure(vtkPolyData* body, const palpate::Ranks& ranks);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  double LengthScale = 1.0;
  bool AskAboutSize = true;
  double LongestSide = 0.0;
  std::vector<std::string> Notes;
};

#endif

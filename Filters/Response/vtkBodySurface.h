// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBodySurface
 * @brief   any surface or volume as triangles in millimetres, a body to be touched
 *
 * Input: any vtkDataSet, or a composite of them (multi-block, partitioned, collections). Other data
 * - tables, graphs, adaptive grids - are an error that names the filter to use before. Empty
 * input gives empty output.
 *
 * Output: one vtkPolyData of triangles that wind counter-clockwise seen from outside, in mm:
 * - a surface of triangles alone comes out as it is, with all its arrays, if it is sound;
 * - triangles that wind inward or against their neighbours are turned, part by part
 *   (palpate/SoundMesh.h); stored normals do not count. An inner part that winds inward is a
 * cavity;
 * - triangles that occur twice, enclose nothing, as at the seams of merged scans, or have a
 * coordinate that is not finite are left out; points stay;
 * - polygons and triangle strips are cut into triangles, vertices and lines left out;
 * - of a volume (unstructured, structured, rectilinear, image) the outer faces of its
 *   three-dimensional cells are taken; cells of fewer dimensions are left out. Of an image that is
 * its box; the skin of a scan is vtkSkinSurface's;
 * - partitions of one data set (vtkPartitionedDataSet, vtkMultiPieceDataSet) are joined where their
 *   points coincide exactly, their ghost cells left out, and so are all blocks that are volumes;
 * - other blocks are appended in their order, and are not joined: they must not overlap. A block
 *   without triangles is left out if another has some.
 *
 * Point arrays are kept as they are, whatever their unit; several blocks or partitions keep those
 * that all of them have, and a warning names the others. Notes say what was done.
 *
 * **Unit of length.** Coordinates are converted to millimetres by the LengthUnit of the input (or
 * any other LengthScale). A body whose longest side is then below 5 mm or above 5000 mm raises one
 * warning, which asks whether the Length Unit is right (AskAboutSize).
 *
 * Errors, each naming the block if there are several: a cell that names a point which is not there;
 * cells of a volume that are inverted, a polygon that cannot be cut, a part that is a second body
 * in another one or a sheet with two sides (each by its number); no triangles at all, naming the
 * filter that makes some from points or lines; a LengthScale that is not positive.
 *
 * **Several processes**: each may have a piece of the body, or none (Controller); errors, the
 * turning of a closed surface and the size are those of the whole, and one process warns. Walls at
 * the seams of a volume are removed: they are recognised by ghost cells (one level is requested),
 * by the extent of a structured grid, or as faces that occur twice.
 *
 * Cost: 0.3 s per million triangles; cells and coordinates of a sound surface in mm are shared with
 * the input.
 *
 * Single-threaded; the output is the same on every run. Abort is ignored.
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
   * The unit of the input's coordinates: Millimetre (default), Centimetre or Metre. Get returns -1
   * for a LengthScale that is none of these.
   */
  void SetLengthUnit(int unit);
  int GetLengthUnit();
  void SetLengthUnitToMillimetre() { this->SetLengthUnit(Millimetre); }
  void SetLengthUnitToCentimetre() { this->SetLengthUnit(Centimetre); }
  void SetLengthUnitToMetre() { this->SetLengthUnit(Metre); }
  ///@}

  ///@{
  /** Millimetres per unit of the input's coordinates, positive; the same as LengthUnit. Default 1.
   */
  vtkSetMacro(LengthScale, double);
  vtkGetMacro(LengthScale, double);
  ///@}

  ///@{
  /** Whether a doubtful size raises a warning. Default on. */
  vtkSetMacro(AskAboutSize, bool);
  vtkGetMacro(AskAboutSize, bool);
  vtkBooleanMacro(AskAboutSize, bool);
  ///@}

  ///@{
  /** The processes that have pieces of the body. Default: the global controller, if there is one.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** The longest side of a box along the axes around the last body, mm; 0 if it is empty. */
  vtkGetMacro(LongestSide, double);

  /** Whether a body with this longest side, mm, probably has another unit: < 5 or > 5000. */
  static bool IsSizeDoubtful(double longestSide);

  ///@{
  /** What was done to the last input; each note is part of a sentence. */
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
   * Joins the blocks; returns what is wrong with them, or "". `missing`: why one has no triangles.
   */
  std::string Gather(
    vtkInformation* input, vtkPolyData* output, const palpate::Ranks& ranks, std::string& missing);
  /** Turns a closed surface in pieces on several ranks, if it is inside out. */
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

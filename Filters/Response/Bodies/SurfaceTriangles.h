// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Conversion of one data set, whole or in partitions, to triangles.
 *
 * A surface that consists only of triangles is returned unchanged if it is sound. Polygons and
 * strips are cut; vertices and lines are left out. For a volume, the outer faces are used.
 * Partitions are joined where their points coincide exactly, and ghost cells are left out.
 */
#ifndef SurfaceTriangles_h
#define SurfaceTriangles_h

#include "Response/Bodies/SoundBody.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace palpate
{
struct SurfaceTriangles
{
  vtkSmartPointer<vtkPolyData> surface; // the triangles; null after a fault
  bool isOfVolume = false;
  std::vector<std::string> notes; // changes to the input; each note is part of a sentence
  // Description of unused input, for a warning; "" if the whole input is used.
  std::string loss;
  std::string fault;    // the reason why no triangles were made, or ""
  bool isEmpty = false; // whether the only fault is that the input has no triangles
};

/// Extracts the surface, which may still contain polygons and strips. `wholeExtent` is the extent
/// of a structured grid over the pieces of all ranks. Only the faces of this extent belong to the
/// surface. Null means that the grid is whole. All pieces must have points.
SurfaceTriangles extractSurface(const std::vector<vtkDataSet*>& pieces, const int* wholeExtent);

/// Cuts the surface into triangles and orients them (SoundMesh). Sets a fault if no triangles
/// result, or if the triangles are not a body.
void cutSurface(
  SurfaceTriangles& made, const std::vector<vtkDataSet*>& pieces, SoundBody::Extent extent);

/// Returns the names of point arrays that some of the data sets have and others lack,
/// comma-separated. These arrays are lost when the data sets are appended.
std::string arraysNotShared(const std::vector<vtkDataSet*>& pieces);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * One data set, whole or in partitions, as triangles.
 *
 * A surface of triangles alone is returned unchanged if it is sound. Polygons and strips are cut;
 * vertices and lines are left out. For a volume, the outer faces are used. Partitions are joined
 * where their points coincide exactly, and ghost cells are left out.
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
  vtkSmartPointer<vtkPolyData> surface; // null after a fault
  bool isOfVolume = false;
  std::vector<std::string> notes; // changes, each part of a sentence
  std::string loss;               // unused input, for a warning; "" if all is used
  std::string fault;              // the reason why no triangles were made, or ""
  bool isEmpty = false;           // whether the only fault is that the input has no triangles
};

/// Extracts the surface, still with polygons and strips. `wholeExtent`: extent of the pieces of all
/// ranks of a structured grid; only the faces of this extent belong to the surface. Null: the grid
/// is whole. Pieces must have points.
SurfaceTriangles extractSurface(const std::vector<vtkDataSet*>& pieces, const int* wholeExtent);

/// Cuts the surface into triangles and orients them (SoundMesh). Sets a fault if no triangles
/// result, or if they are not a body.
void cutSurface(
  SurfaceTriangles& made, const std::vector<vtkDataSet*>& pieces, SoundBody::Extent extent);

/// Names of point arrays that some of the data sets have and others lack, comma-separated.
/// Appending loses them.
std::string arraysNotShared(const std::vector<vtkDataSet*>& pieces);
} // namespace palpate

#endif

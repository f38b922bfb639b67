// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the body of the command line, as a surface for contact, from a file of any supported kind.
 *
 * A .palpate file is a body with its response in mm, as written by --export. Files .vtp, .stl,
 * .ply, .obj and .vtk contain surfaces, files .vtu and .vtk volume meshes; vtkBodySurface converts
 * both. Files .vti, .vtk, .nii and .nii.gz contain scans, whose outer skin vtkSkinSurface finds. If
 * a base value is given, the skin has the array LayerThickness (mm), see vtkLayerThickness.
 *
 * The body is in millimetres. The header of a NIfTI scan defines its position. A valid .vtp or .vtk
 * of triangles is unchanged and keeps all its arrays.
 */
#ifndef palpate_BodyFile_h
#define palpate_BodyFile_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
struct BodyFileOptions
{
  double lengthScale = 1.0; // length of the file's unit, mm
  // For a scan, resolution of the skin, mm; 0 for the scan's own resolution.
  double resolution = 0.0;
  double contourValue = 0.0;  // for a scan, grey level of the skin; 0 if it is chosen from the scan
  double closingRadius = 6.0; // for a scan, openings up to twice this size are closed, mm
  std::optional<double> baseValue; // for a scan, grey level below which a voxel is bone
};

struct BodyFileResult
{
  vtkSmartPointer<vtkPolyData> body; // body of triangles; null after an error
  std::vector<std::string> notes;    // changes to the content of the file, one sentence per change
  std::string error;                 // an error that names the file; "" on success
};

/// Reads `path`. Never throws. Messages of the readers become part of the error and are not
/// printed. During the call VTK's output window is replaced; therefore only one thread may call
/// this function.
BodyFileResult readBodyFile(const std::string& path, const BodyFileOptions& options);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the body of the command line, of any kind, as a surface for contact.
 *
 * .palpate: a body with its response, as written by --export; in mm already. .vtp .stl .ply .obj
 * .vtk: surfaces; .vtu .vtk: volume meshes. For their conversion see vtkBodySurface. .vti .vtk .nii
 * .nii.gz: scans. Their outer skin is used, see vtkSkinSurface. If a base value is given, the skin
 * has the array LayerThickness (mm), see vtkLayerThickness.
 *
 * The body is in millimetres. A NIfTI scan is positioned by its header. A valid .vtp or .vtk of
 * triangles is unchanged, with all its arrays.
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
  double lengthScale = 1.0;        // mm per unit of length of the file
  double resolution = 0.0;         // for a scan, mm; 0: its own resolution
  double contourValue = 30.0;      // for a scan: grey level of the skin
  double closingRadius = 6.0;      // for a scan, mm: openings of up to twice this size are closed
  std::optional<double> baseValue; // for a scan: grey level below which it is bone
};

struct BodyFileResult
{
  vtkSmartPointer<vtkPolyData> body; // triangles only; null after an error
  std::vector<std::string> notes;    // changes to the content of the file, one sentence each
  std::string error;                 // names the file; "" on success
};

/// Reads `path`. Never throws. Messages of the readers go into the error, not to the console: VTK's
/// output window is replaced during the call, so call this from one thread only.
BodyFileResult readBodyFile(const std::string& path, const BodyFileOptions& options);
} // namespace palpate

#endif

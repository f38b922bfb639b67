// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ViewerFooter_h
#define palpate_ViewerFooter_h

namespace palpate
{
/// The text below the list of options in the viewer's help, about units, files and examples.
inline constexpr const char* ViewerFooter =
  R"(Units: mm, N, MPa, s. Tools: flat:R, sphere:R, paraboloid:R, cone:DEGREES (from the axis),
truncated:R,DEGREES (R: of the flat), blunted:R,DEGREES (R: of the tip), rounded:R,EDGE, power:EXPONENT,COEFFICIENT,
profile:FILE.csv (a line r_mm,f_mm per point, from 0,0 outward).

Files: .palpate (written by --export), .vtp .stl .ply .obj .vtk (surfaces), .vtu (volume meshes: their surface is taken),
.nii .nii.gz .vti (scans: their outer skin is taken; with --tissue segmentations: their tissues are taken).

Environment: PALPATE_THREADS, the largest number of threads of pre-computations (default: one per core). No result
depends on it.

Examples:
  palpate                                    the head of Debian's mricron-data, three tools
  palpate --scene cylinder                   the scene of Mahvash and Hayward 2002, Figure 9
  palpate --scene phantom --window           nine hard nodules in soft tissue, to be found
  palpate --scene phantom --map              where a tool can feel them, and how strongly
  palpate liver.stl --tool sphere:6.35 --young 0.05 --poisson 0.45
  palpate liver.stl --measured press.csv --tool sphere:1.6   touched with another tool than measured
  palpate liver.stl --tool sphere:6.35 --voxel 2 --fixed z-   as a solid that lies on its lowest side
  palpate liver.stl --tool sphere:6.35 --solid               its true shape, by finite elements
  palpate labels.nii.gz --tissue 1:0.006:0.49 --tissue 2:0.06:0.49   a segmentation with a lump: a map of the force
  palpate liver.stl --layer 10               as a layer of 10 mm on a rigid base
  palpate --layers scan                      the head as skin over fat over bone
  palpate liver.stl --layers 1.5:0.2:0.48,6:0.03:0.49   two layers, outermost first, on a rigid base
  palpate --compare                          a body that bends next to a body that dents, same tools
  palpate --map                              where on the head the shape of the tool matters
  palpate --window                           the head in a window, under the mouse
  palpate --window --device hid:/dev/hidraw0 under a device of --list-devices
  palpate --window --hand simulated          two fingers, each of which feels the other
  palpate --scene cylinder --window --trial sphere:6.35,flat:1.6   which is which, by feel
  palpate --scene phantom --window --trial lump,none   under which one is the lump?
  palpate phantom.obj --length-unit m --site 0,0,1 --slide-to 0.3,0,1 --depth 1.5)";
} // namespace palpate

#endif

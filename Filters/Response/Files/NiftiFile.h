// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NiftiFile_h
#define palpate_NiftiFile_h

#include <string>
#include <vector>

class vtkNIFTIImageReader;
class vtkImageData;

namespace palpate
{
/// Why the header of a NIfTI file is not that of one image of three dimensions that the file may
/// hold, or "". A compressed file is taken to hold at most 1032 times its size, the most of
/// DEFLATE.
std::string niftiFault(vtkNIFTIImageReader* reader);

/// Applies the header to the image that was read: values times scl_slope plus scl_inter, and
/// coordinates by the sform, or else the qform, in millimetres. Without either the first voxel is
/// the origin, and the axes are those of the voxels. Returns what is wrong with the header, or "".
std::string applyNiftiHeader(
  vtkNIFTIImageReader* reader, vtkImageData* image, std::vector<std::string>& notes);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NiftiFile_h
#define palpate_NiftiFile_h

#include <string>
#include <vector>

class vtkNIFTIImageReader;
class vtkImageData;

namespace palpate
{
/// Checks that the header of a NIfTI file describes one three-dimensional image that can fit in the
/// file. Returns "" or an error message. A compressed file can contain at most 1032 times its own
/// size, the maximum of DEFLATE.
std::string niftiFault(vtkNIFTIImageReader* reader);

/// Applies the header to the image that was read: values times scl_slope plus scl_inter, and
/// coordinates by the sform, otherwise by the qform, in millimetres. Without either, the first
/// voxel is the origin and the axes are those of the voxels. Returns "" or an error in the header.
std::string applyNiftiHeader(
  vtkNIFTIImageReader* reader, vtkImageData* image, std::vector<std::string>& notes);
} // namespace palpate

#endif

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
/// file. Returns "" or an error message. The content of a compressed file can be at most 1032 times
/// as large as the file, because this is the largest ratio of DEFLATE.
std::string niftiFault(vtkNIFTIImageReader* reader);

/// Applies the header to the image that was read. The values are multiplied by scl_slope and
/// increased by scl_inter. The coordinates follow from the sform, otherwise from the qform, in
/// millimetres. Without either, the first voxel is the origin and the axes are those of the voxels.
/// Returns "" or an error in the header.
std::string applyNiftiHeader(
  vtkNIFTIImageReader* reader, vtkImageData* image, std::vector<std::string>& notes);
} // namespace palpate

#endif

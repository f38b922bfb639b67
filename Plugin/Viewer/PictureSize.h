// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PictureSize_h
#define palpate_PictureSize_h

namespace palpate
{
/// Size of windows and pictures, in pixels.
constexpr int PictureWidth = 1280;
constexpr int PictureHeight = 960;
} // namespace palpate

#endif

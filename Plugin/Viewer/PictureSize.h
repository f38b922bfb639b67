// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PictureSize_h
#define palpate_PictureSize_h

class vtkRenderWindow;

namespace palpate
{
/// Size of pictures, in pixels.
constexpr int PictureWidth = 1280;
constexpr int PictureHeight = 960;

/// Sets the size of a window to the size of a picture, or to the free area of the screen if this
/// area is smaller.
void fitToScreen(vtkRenderWindow* window);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PictureSize_h
#define palpate_PictureSize_h

class vtkRenderWindow;

namespace palpate
{
/// Size of pictures, in pixels.
constexpr int PictureWidth = 1280;
constexpr int PictureHeight = 960;

/// Gives a window the size of a picture. If the screen's free area is smaller, the window gets the
/// size of that area.
void fitToScreen(vtkRenderWindow* window);
} // namespace palpate

#endif

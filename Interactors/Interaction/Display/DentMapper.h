// SPDX-License-Identifier: BSD-3-Clause
#ifndef DentMapper_h
#define DentMapper_h

#include "vtkOpenGLPolyDataMapper.h"

namespace palpate
{
/**
 * Draws a body whose vertices a DeflectionShader moves: keeps the shader's colours those of the
 * lookup table, and lets the bounds reach to where the vertices go. Its points are not shifted and
 * scaled: coordinates are floats, the origin must not be some thousand times the size of the body
 * away.
 */
class DentMapper : public vtkOpenGLPolyDataMapper
{
public:
  static DentMapper* New();
  vtkTypeMacro(DentMapper, vtkOpenGLPolyDataMapper);

  /// The bounds contain this point, and `around` mm about the body.
  void setDent(const double deepest[3], double around);

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;

protected:
  DentMapper();
  void ComputeBounds() override;

private:
  DentMapper(const DentMapper&) = delete;
  void operator=(const DentMapper&) = delete;

  void updateColors();

  double Deepest[3] = { 0.0, 0.0, 0.0 };
  double Around = -1.0; ///< < 0: no dent
  vtkMTimeType ColorsTime = 0;
  float Coordinates[3] = { 0.0F, 0.0F, 0.0F }; ///< as DeflectionShader::setColors takes them
};
} // namespace palpate

#endif

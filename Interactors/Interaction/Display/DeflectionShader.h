// SPDX-License-Identifier: BSD-3-Clause
#ifndef DeflectionShader_h
#define DeflectionShader_h

#include "Laws/ContactField.h"

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkShaderProperty;

namespace palpate
{
/**
 * A ContactField in the vertex shader of an actor: moves the vertices, turns their normals and
 * gives each the texture coordinate of its displacement's length, from uniforms alone. What a
 * frame costs the processor does not depend on the mesh.
 *
 * Of the mapper it needs the point array SurfaceNormals as the vertex attribute `palpateSurface`
 * (angle-weighted normals), for each global mode the attributes that ModeAttributes makes, points
 * that are not shifted and scaled, and scalars that are interpolated before mapping.
 *
 * As in vtkContactDeflection r is the length of the arc from the contact and the field ends 60°
 * from the contact normal. Unlike it a vertex does not know whether the surface connects it to the
 * contact: a fold or another part of the body within the reach of the field, and facing the same
 * way, moves along. The reach (FieldRadii) bounds that.
 *
 * The turned normal follows the slopes of the table: over two edges of the mesh.
 */
class DeflectionShader
{
public:
  static constexpr const char* NormalAttribute = "palpateSurface";
  /// Reach of a field that is given none, contact radii: exact within 15, where 4 % are left.
  static constexpr double FieldRadii = 20.0;

  /// Where a field ends, mm: its reach, or FieldRadii contact radii if it has none.
  static double reachOf(const ContactField& field);

  explicit DeflectionShader(vtkActor* actor);

  /// Puts the code into the shaders of the actor, for a body with so many global modes, and with or
  /// without a near field; again to change these.
  void install(int modes, bool hasNearField);
  void remove();

  /// `edge` is the length of an edge of the mesh, mm; `exaggeration` multiplies what is drawn, not
  /// its colour.
  void show(
    const ContactField& field, const FieldContact& contact, double edge, double exaggeration);

  /// Texture coordinates of a length u, mm: (start + perLength u, row).
  static void setColors(vtkShaderProperty* property, float start, float perLength, float row);

private:
  vtkSmartPointer<vtkShaderProperty> Property;
  int Modes = -1; ///< of the code that is installed; -1: none
  bool HasNearField = false;
};

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

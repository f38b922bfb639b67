// SPDX-License-Identifier: BSD-3-Clause
#ifndef DeflectionShader_h
#define DeflectionShader_h

#include "Laws/ContactField.h"

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkShaderProperty;

namespace palpate
{
/// The data of one contact for the shader.
struct DrawnDent
{
  ContactField field;
  FieldContact contact;
  double edge = 1.0; ///< length of the edges of the mesh, mm
};

/**
 * Evaluates ContactFields in the vertex shader of an actor. It moves the vertices, turns their
 * normals, and sets the texture coordinate of each vertex from the length of its displacement. The
 * data are passed only as uniforms, so the processor time of a frame does not depend on the mesh.
 * Fields of several contacts add up.
 *
 * The mapper must provide:
 * - the point array SurfaceNormals (angle-weighted normals) as the vertex attribute
 *   `palpateSurface`;
 * - the attributes that addModeAttributes makes for the global modes;
 * - points that are not shifted and scaled;
 * - scalars that are interpolated before mapping.
 *
 * As in vtkContactDeflection, r is the length of the arc from the contact, and the field ends 60°
 * from the contact normal. Unlike vtkContactDeflection, the shader does not check that the surface
 * is connected: a fold or another part of the body moves, too, if it is within the reach of the
 * field and faces the same way. A small reach (FieldRadii) limits this error.
 *
 * The turned normal is computed from the slopes of the table, which are taken over two edges of the
 * mesh.
 */
class DeflectionShader
{
public:
  static constexpr const char* NormalAttribute = "palpateSurface";
  /// Default reach of a field, in contact radii. The field is exact up to 15 contact radii, where
  /// 4 % of it remain, and fades beyond.
  static constexpr double FieldRadii = 20.0;

  /// Distance at which a field ends, mm: the reach of the field, or FieldRadii contact radii if it
  /// has no reach.
  static double reachOf(const ContactField& field);

  explicit DeflectionShader(vtkActor* actor);

  /// The parameters of the code in the shaders.
  struct Code
  {
    int modes = 0; ///< number of global modes of the body
    bool hasNearField = false;
    int contacts = 1; ///< each contact needs 600 floats of uniforms; OpenGL 3.2 guarantees space
                      ///< for one contact, graphics cards have space for six

    bool operator==(const Code& other) const
    {
      return this->modes == other.modes && this->hasNearField == other.hasNearField &&
        this->contacts == other.contacts;
    }
  };
  /// Puts the code into the shaders of the actor. Call it again to change the code.
  void install(const Code& code);
  void remove();

  /// Shows the dents, at most as many as the code has contacts. `exaggeration` multiplies the
  /// displacement, not the length that gives the colour.
  void show(const std::vector<DrawnDent>& dents, double exaggeration);

  /// Sets the texture coordinates of a length u, mm: (start + perLength u, row).
  static void setColors(vtkShaderProperty* property, float start, float perLength, float row);

private:
  vtkSmartPointer<vtkShaderProperty> Property;
  Code Installed;
  bool IsInstalled = false;
};

/**
 * Draws a body whose vertices a DeflectionShader moves. It keeps the colours of the shader equal to
 * those of the lookup table and includes the displaced vertices in the bounds. Points are not
 * shifted and scaled. Coordinates are floats, so the distance of the body from the origin must be
 * at most a few thousand times the size of the body.
 */
class DentMapper : public vtkOpenGLPolyDataMapper
{
public:
  static DentMapper* New();
  vtkTypeMacro(DentMapper, vtkOpenGLPolyDataMapper);

  /// Extends the bounds to the point `deepest`, and by `around` mm on all sides of the body.
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
  double BoundsMargin = -1.0; ///< < 0: no dent
  vtkMTimeType ColorsTime = 0;
  float Coordinates[3] = { 0.0F, 0.0F, 0.0F }; ///< for DeflectionShader::setColors
};
} // namespace palpate

#endif

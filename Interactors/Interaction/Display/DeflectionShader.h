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
  double edge = 1.0; ///< length of the mesh's edges, mm
};

/**
 * ContactFields in the vertex shader of an actor: moves the vertices, turns their normals and gives
 * each the texture coordinate of its displacement's length, from uniforms alone. A frame's cost on
 * the processor does not depend on the mesh. Fields of several contacts add up.
 *
 * Of the mapper it needs the point array SurfaceNormals as the vertex attribute `palpateSurface`
 * (angle-weighted normals), for each global mode the attributes that addModeAttributes makes,
 * points that are not shifted and scaled, and scalars that are interpolated before mapping.
 *
 * As in vtkContactDeflection r is the length of the arc from the contact and the field ends 60°
 * from the contact normal. Unlike there, connection along the surface is not checked: a fold or
 * another part of the body within the reach of the field, and facing the same way, moves along. The
 * reach (FieldRadii) limits that.
 *
 * The turned normal follows the slopes of the table, taken over two edges of the mesh.
 */
class DeflectionShader
{
public:
  static constexpr const char* NormalAttribute = "palpateSurface";
  /// Default reach of a field, in contact radii: exact within 15, where 4 % remain.
  static constexpr double FieldRadii = 20.0;

  /// Where a field ends, mm: its reach, or FieldRadii contact radii if it has none.
  static double reachOf(const ContactField& field);

  explicit DeflectionShader(vtkActor* actor);

  /// The parameters of the code in the shaders.
  struct Code
  {
    int modes = 0; ///< global ones of the body
    bool hasNearField = false;
    int contacts = 1; ///< 600 floats of uniforms each: OpenGL 3.2 has room for one, cards for six

    bool operator==(const Code& other) const
    {
      return this->modes == other.modes && this->hasNearField == other.hasNearField &&
        this->contacts == other.contacts;
    }
  };
  /// Puts the code into the shaders of the actor; again to change it.
  void install(const Code& code);
  void remove();

  /// No more dents than the code has contacts; `exaggeration` multiplies the displacement, not its
  /// colour.
  void show(const std::vector<DrawnDent>& dents, double exaggeration);

  /// Texture coordinates of a length u, mm: (start + perLength u, row).
  static void setColors(vtkShaderProperty* property, float start, float perLength, float row);

private:
  vtkSmartPointer<vtkShaderProperty> Property;
  Code Installed;
  bool IsInstalled = false;
};

/**
 * Draws a body whose vertices a DeflectionShader moves: keeps the shader's colours equal to the
 * lookup table's, and includes the displaced vertices in the bounds. Its points are not shifted and
 * scaled: as coordinates are floats, the origin must not be more than some thousand times the size
 * of the body away.
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
  float Coordinates[3] = { 0.0F, 0.0F, 0.0F }; ///< for DeflectionShader::setColors
};
} // namespace palpate

#endif

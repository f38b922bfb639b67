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
/// Data of one contact for the shader.
struct DrawnDent
{
  ContactField field;
  FieldContact contact;
  double edge = 1.0; ///< edge length of the mesh at the contact, mm
};

/**
 * Evaluates ContactFields in the vertex shader of an actor. The shader moves the vertices, rotates
 * their normals, and sets the texture coordinate of each vertex from the length of its
 * displacement. The data are passed only as uniforms, so that the processor time of a frame does
 * not depend on the mesh. The fields of several contacts are added.
 *
 * The mapper must provide:
 * - the point array SurfaceNormals (angle-weighted normals) as the vertex attribute
 * `palpateSurface`;
 * - the attributes that addModeAttributes makes for the global modes;
 * - points that are neither shifted nor scaled;
 * - scalars that are interpolated before mapping.
 *
 * As in vtkContactDeflection, r is the length of the arc from the contact, and the field ends where
 * the normal is at 60° to the contact normal. Unlike vtkContactDeflection, the shader does not
 * check whether the surface is connected. A fold or another part of the body also moves if it is
 * within the reach of the field and its normal has a similar direction. A small reach (FieldRadii)
 * limits this error.
 *
 * The rotated normal is computed from the slopes in the table. The slopes are differences over two
 * edge lengths of the mesh.
 */
class DeflectionShader
{
public:
  static constexpr const char* NormalAttribute = "palpateSurface";
  /// Default reach of a field, in contact radii. The field is exact up to 15 contact radii, where
  /// it is 4 % of the deflection, and fades beyond that distance.
  static constexpr double FieldRadii = 20.0;

  /// Distance at which a field ends, mm. It is the reach of the field, or FieldRadii contact radii
  /// if the reach is not limited.
  static double reachOf(const ContactField& field);

  explicit DeflectionShader(vtkActor* actor);

  /// Parameters on which the code of the shader depends.
  struct Code
  {
    int modes = 0; ///< number of global modes of the body
    bool hasNearField = false;
    /// Number of contacts. Each contact needs 600 floats of uniforms. OpenGL 3.2 guarantees space
    /// for one contact; graphics cards have space for six.
    int contacts = 1;

    bool operator==(const Code& other) const
    {
      return this->modes == other.modes && this->hasNearField == other.hasNearField &&
        this->contacts == other.contacts;
    }
  };
  /// Inserts the code into the shaders of the actor. Call it again to change the parameters.
  void install(const Code& code);
  void remove();

  /// Shows the dents. There must not be more dents than Code::contacts. `exaggeration` multiplies
  /// the displacement, but not the length that determines the colour.
  void show(const std::vector<DrawnDent>& dents, double exaggeration);

  /// Sets the conversion of a length u (mm) to the texture coordinates (start + perLength u, row).
  static void setColors(vtkShaderProperty* property, float start, float perLength, float row);

private:
  vtkSmartPointer<vtkShaderProperty> Property;
  Code Installed;
  bool IsInstalled = false;
};

/**
 * Draws a body whose vertices are moved by a DeflectionShader. It updates the colours of the shader
 * when the lookup table changes, and includes the displaced vertices in the bounds. Points are
 * neither shifted nor scaled. Coordinates are floats. Therefore the distance of the body from the
 * origin must be at most a few thousand times the size of the body.
 */
class DentMapper : public vtkOpenGLPolyDataMapper
{
public:
  static DentMapper* New();
  vtkTypeMacro(DentMapper, vtkOpenGLPolyDataMapper);

  /// Extends the bounds to the point `deepest`, and by `around` (mm) on all sides of the body.
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
  double BoundsMargin = -1.0; ///< mm; negative if there is no dent
  vtkMTimeType ColorsTime = 0;
  float Coordinates[3] = { 0.0F, 0.0F, 0.0F }; ///< arguments of DeflectionShader::setColors
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/DeflectionShader.h"

#include "Interaction/Display/DeflectionTable.h"
#include "Interaction/Display/ModeAttributes.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <algorithm>
#include <string>

namespace palpate
{
namespace
{
constexpr const char* Declarations = "//VTK::PositionVC::Dec";
constexpr const char* Beginning = "//VTK::CustomBegin::Impl";

// Functions of the shader. palpateRange: contact radius, q at the kink, q at the reach, reach;
// palpateDraw: exaggeration, intervals of the table, where the fade begins: cosine, distance.
// Without branches, since software renderers compute both sides of one.
constexpr const char* Functions = R"(
in vec3 palpateSurface;

#if PALPATE_NEAR
// ContactField::near. palpateNear: slope, depth; palpateBend: xx yy zz, radius; palpateTwist: xy yz
// zx, depth within the contact; palpateStep: the length over which slopes are taken.
float palpateSink(vec3 d)
{
  float r = max(length(d), 1e-6 * palpateRange.x);
  float kappa = min(1.0, palpateBend.w / r);
  float part = min(1.0, palpateRange.x / r);
  float held = 0.63661977 * (asin(part) - part * sqrt(1.0 - part * part));
  vec3 known = kappa * d;
  vec3 bent = vec3(dot(vec3(palpateBend.x, palpateTwist.x, palpateTwist.z), known),
    dot(vec3(palpateTwist.x, palpateBend.y, palpateTwist.y), known),
    dot(vec3(palpateTwist.z, palpateTwist.y, palpateBend.z), known));
  return mix(kappa * kappa * (palpateNear.w + dot(palpateNear.xyz + bent, known)), palpateTwist.w,
    held);
}

// palpateSink and its slopes away from the contact and across.
vec3 palpateSinkAt(float r, vec3 away)
{
  vec3 along = away - dot(away, palpateNormal) * palpateNormal;
  float len = length(along);
  along = len > 1e-6 ? along / len : vec3(0.0);
  vec3 d = r * along;
  float h = palpateStep;
  vec3 across = h * cross(palpateNormal, along);
  return vec3(palpateSink(d),
    (palpateSink(d + h * along) - palpateSink(d - h * along)) / (2.0 * h),
    (palpateSink(d + across) - palpateSink(d - across)) / (2.0 * h));
}
#endif

// u_r, u_z and their slopes at the distance r: DeflectionTable.
vec4 palpateLaw(float r)
{
  float a = palpateRange.x;
  float root = sqrt(abs(a - r) * (a + r));
  bool outside = r >= a;
  float q = (outside ? a : r) / ((outside ? r : a) + root);
  bool tip = !outside && q < palpateRange.y;
  float begin = outside ? palpateRange.z : tip ? 0.0 : palpateRange.y;
  float end = tip ? palpateRange.y : 1.0;
  float t = palpateDraw.y * clamp((q - begin) / (end - begin), 0.0, 1.0);
  float cell = min(floor(t), palpateDraw.y - 1.0);
  int i = int((outside ? 2.0 : tip ? 0.0 : 1.0) * (palpateDraw.y + 1.0) + cell);
  return mix(palpateTable[i], palpateTable[i + 1], t - cell);
}

// The local displacement of x with the normal n, which is turned.
vec3 palpateLocal(vec3 x, inout vec3 n)
{
  vec3 chord = x - palpateContact;
  float height = dot(chord, palpateNormal);
  float cosine = dot(n, palpateNormal);
  float len = length(chord);
  float sine = (dot(n, chord) - cosine * height)
    / sqrt(max(len * len - height * height, 1e-12 * palpateRange.x * palpateRange.x));
  // r = chord (turn/2)/sin(turn/2), by the series of the arc sine: 2e-5 at 60 degrees.
  float square = 0.5 - 0.5 * cosine * inversesqrt(max(cosine * cosine + sine * sine, 1e-12));
  float arc = 1.0 + square * (0.16666667 + square * (0.075 + square * (0.04464286
    + square * (0.03038194 + square * 0.02237216))));
  float r = len * arc;
  vec3 away = chord - dot(chord, n) * n;
  float awayLength = length(away);
  bool apart = awayLength > 1e-6 * palpateRange.x;
  away = apart ? away / awayLength : vec3(0.0);

  vec4 law = palpateLaw(r);
#if PALPATE_NEAR
  vec3 sink = palpateSinkAt(r, away);
  law.y += sink.x;
  law.w += sink.y;
#endif
  float fading = palpateRange.w - palpateDraw.w;
  float t = clamp((r - palpateDraw.w) / fading, 0.0, 1.0);
  float turnedAway = clamp((cosine - 0.5) / (palpateDraw.z - 0.5), 0.0, 1.0);
  float share = turnedAway * turnedAway * (3.0 - 2.0 * turnedAway);
  vec2 u = share * (1.0 - t * t * (3.0 - 2.0 * t)) * law.xy;
  vec2 slope = palpateDraw.x * share
    * ((1.0 - t * t * (3.0 - 2.0 * t)) * law.zw - 6.0 * t * (1.0 - t) / fading * law.xy);
  float bend = sign(sine) * 2.0 * sqrt(max(square, 0.0)) / max(len, 1e-6 * palpateRange.x);
  vec3 along = (1.0 + slope.x) * away - palpateDraw.x * u.x * bend * n - slope.y * palpateNormal;
  bool moves = palpateRange.x > 0.0 && share > 0.0 && t < 1.0;
  vec3 across = cross(n, away);
#if PALPATE_NEAR
  across -= palpateDraw.x * share * (1.0 - t * t * (3.0 - 2.0 * t)) * sink.z * palpateNormal;
#endif
  n = moves && apart ? normalize(cross(along, across)) : n;
  return moves ? u.x * away - u.y * palpateNormal : vec3(0.0);
}
)";

/// The vertex moves first of all; what VTK does with it afterwards sees it displaced. Its place in
/// the colours' texture VTK calls tcoord, since 9.3 colorTCoord.
std::string displacement(int modes)
{
  return std::string(R"(
  vec3 palpateNormalMC = palpateSurface;
  vec3 palpateU = palpateLocal(vertexMC.xyz, palpateNormalMC);
)") +
    modeSum(modes, "palpateWeight", "palpateU", "palpateNormalMC", "palpateDraw.x") + R"(
  vec4 palpateVertexMC = vec4(vertexMC.xyz + palpateDraw.x * palpateU, vertexMC.w);
  vec2 palpateCoordinate = vec2(palpateColor.x + palpateColor.y * length(palpateU), palpateColor.z);
#define vertexMC palpateVertexMC
#define normalMC palpateNormalMC
#define tcoord palpateCoordinate
#define colorTCoord palpateCoordinate
)" + Beginning;
}
} // namespace

double DeflectionShader::reachOf(const ContactField& field)
{
  return field.reach() > 0.0 ? field.reach() : FieldRadii * field.contactRadius();
}

DeflectionShader::DeflectionShader(vtkActor* actor)
  : Property(actor->GetShaderProperty())
{
}

void DeflectionShader::install(int modes, bool hasNearField)
{
  if (this->Modes == modes && this->HasNearField == hasNearField)
  {
    return;
  }
  this->remove();
  this->Modes = modes;
  this->HasNearField = hasNearField;
  // Once: uniforms are declared where they are first set.
  setColors(this->Property, 0.0F, 0.0F, 0.0F);
  this->show(ContactField(), FieldContact(), 1.0, 1.0);
  const std::string near = std::string("\n#define PALPATE_NEAR ") + (hasNearField ? "1" : "0");
  this->Property->AddVertexShaderReplacement(
    Declarations, true, near + Functions + modeDeclarations(modes) + Declarations, false);
  this->Property->AddVertexShaderReplacement(Beginning, true, displacement(modes), false);
}

void DeflectionShader::remove()
{
  if (this->Modes >= 0)
  {
    this->Property->ClearVertexShaderReplacement(Declarations, true);
    this->Property->ClearVertexShaderReplacement(Beginning, true);
    this->Modes = -1;
  }
}

void DeflectionShader::show(
  const ContactField& field, const FieldContact& contact, double edge, double exaggeration)
{
  const double reach = reachOf(field);
  const DeflectionTable table(field, reach, edge);
  const float range[4] = { table.radius, table.kink, table.far, static_cast<float>(reach) };
  const float draw[4] = { static_cast<float>(exaggeration),
    static_cast<float>(DeflectionTable::Intervals), static_cast<float>(ContactField::CosineOfFade),
    static_cast<float>(ContactField::FadeBegin * reach) };
  float weights[2 * 4] = {}; // MostModes, in whole vectors
  for (std::size_t k = 0; k < field.modeWeights().size() && k < MostModes; ++k)
  {
    weights[k] = static_cast<float>(field.modeWeights()[k]);
  }
  const NearField& near = field.nearField();
  const auto number = [](double value) { return static_cast<float>(value); };
  const float sink[4] = { number(near.slope[0]), number(near.slope[1]), number(near.slope[2]),
    number(near.depth) };
  const float bend[4] = { number(near.bend(0, 0)), number(near.bend(1, 1)), number(near.bend(2, 2)),
    number(near.radius) };
  const float twist[4] = { number(near.bend(0, 1)), number(near.bend(1, 2)),
    number(near.bend(2, 0)), number(field.nearDepth()) };
  vtkUniforms* uniforms = this->Property->GetVertexCustomUniforms();
  uniforms->SetUniform4f("palpateNear", sink);
  uniforms->SetUniform4f("palpateBend", bend);
  uniforms->SetUniform4f("palpateTwist", twist);
  uniforms->SetUniformf("palpateStep", number(edge));
  uniforms->SetUniform3f("palpateContact", contact.point.data());
  uniforms->SetUniform3f("palpateNormal", contact.normal.data());
  uniforms->SetUniform4f("palpateRange", range);
  uniforms->SetUniform4f("palpateDraw", draw);
  uniforms->SetUniform1fv("palpateWeight", 8, weights);
  uniforms->SetUniform4fv("palpateTable", DeflectionTable::Nodes,
    reinterpret_cast<const float(*)[4]>(table.nodes.data()));
}

void DeflectionShader::setColors(
  vtkShaderProperty* property, float start, float perLength, float row)
{
  const float colors[3] = { start, perLength, row };
  property->GetVertexCustomUniforms()->SetUniform3f("palpateColor", colors);
}

vtkStandardNewMacro(DentMapper);

DentMapper::DentMapper()
{
  this->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

void DentMapper::setDent(const double deepest[3], double around)
{
  std::copy_n(deepest, 3, this->Deepest);
  this->Around = around;
}

void DentMapper::ComputeBounds()
{
  this->Superclass::ComputeBounds();
  if (this->Around >= 0.0 && vtkBoundingBox(this->Bounds).IsValid())
  {
    vtkBoundingBox box(this->Bounds);
    box.Inflate(this->Around);
    box.AddPoint(this->Deepest);
    box.GetBounds(this->Bounds);
  }
}

void DentMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->updateColors();
  DeflectionShader::setColors(
    actor->GetShaderProperty(), this->Coordinates[0], this->Coordinates[1], this->Coordinates[2]);
  this->Superclass::RenderPiece(renderer, actor);
}

// The mapper makes a texture of the lookup table. Where a value lies in it the mapper alone knows,
// and it is asked about the ends of the range.
void DentMapper::updateColors()
{
  vtkScalarsToColors* colors = this->GetLookupTable();
  if (colors->GetMTime() == this->ColorsTime)
  {
    return;
  }
  const double* range = colors->GetRange();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> ends;
  for (int i = 0; i < 2; ++i)
  {
    points->InsertNextPoint(i, 0.0, 0.0);
    ends->InsertNextValue(static_cast<float>(range[i]));
  }
  vtkNew<vtkPolyData> two;
  two->SetPoints(points);
  two->GetPointData()->SetScalars(ends);
  vtkNew<vtkPolyDataMapper> asked;
  asked->SetInputData(two);
  asked->SetLookupTable(colors);
  asked->UseLookupTableScalarRangeOn();
  asked->InterpolateScalarsBeforeMappingOn();
  asked->MapScalars(two, 1.0);
  vtkFloatArray* found = asked->GetColorCoordinates();
  if (found && range[1] > range[0])
  {
    const float low = found->GetTypedComponent(0, 0);
    const float perLength =
      (found->GetTypedComponent(1, 0) - low) / static_cast<float>(range[1] - range[0]);
    this->Coordinates[0] = low - perLength * static_cast<float>(range[0]);
    this->Coordinates[1] = perLength;
    this->Coordinates[2] = found->GetTypedComponent(0, 1);
  }
  this->ColorsTime = colors->GetMTime();
}
} // namespace palpate

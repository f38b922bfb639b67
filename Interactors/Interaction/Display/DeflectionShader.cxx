// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/DeflectionShader.h"

#include "Interaction/Display/DeflectionTable.h"
#include "Interaction/Display/DrawnSurface.h"

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
#include <array>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
constexpr const char* Declarations = "//VTK::PositionVC::Dec";
constexpr const char* Beginning = "//VTK::CustomBegin::Impl";

// Functions of the shader for the contact with index h. palpateRange: contact radius, q at the
// kink, q at the reach, reach; DeflectionTable defines q. palpateDraw: exaggeration, number of
// intervals of the table, start of the fade as the cosine of an angle and as a distance. The
// functions have no branches, because software renderers compute both sides of a branch.
constexpr const char* Functions = R"(
in vec3 palpateSurface;

#if PALPATE_NEAR
// ContactField::near. palpateNear: slope, depth; palpateBend: xx yy zz, radius; palpateTwist: xy yz
// zx, depth within the contact; palpateStep: the length over which slopes are taken.
float palpateSink(int h, vec3 d)
{
  float r = max(length(d), 1e-6 * palpateRange[h].x);
  vec4 bend = palpateBend[h];
  vec4 twist = palpateTwist[h];
  float kappa = min(1.0, bend.w / r);
  float part = min(1.0, palpateRange[h].x / r);
  float held = 0.63661977 * (asin(part) - part * sqrt(1.0 - part * part));
  vec3 known = kappa * d;
  vec3 bent = vec3(dot(vec3(bend.x, twist.x, twist.z), known),
    dot(vec3(twist.x, bend.y, twist.y), known),
    dot(vec3(twist.z, twist.y, bend.z), known));
  return mix(kappa * kappa * (palpateNear[h].w + dot(palpateNear[h].xyz + bent, known)), twist.w,
    held);
}

// palpateSink and its slopes away from the contact and across.
vec3 palpateSinkAt(int h, float r, vec3 away)
{
  vec3 along = away - dot(away, palpateNormal[h]) * palpateNormal[h];
  float len = length(along);
  along = len > 1e-6 ? along / len : vec3(0.0);
  vec3 d = r * along;
  float step = palpateStep[h];
  vec3 across = step * cross(palpateNormal[h], along);
  return vec3(palpateSink(h, d),
    (palpateSink(h, d + step * along) - palpateSink(h, d - step * along)) / (2.0 * step),
    (palpateSink(h, d + across) - palpateSink(h, d - across)) / (2.0 * step));
}
#endif

// u_r, u_z and their slopes at the distance r: DeflectionTable.
vec4 palpateLaw(int h, float r)
{
  float a = palpateRange[h].x;
  float root = sqrt(abs(a - r) * (a + r));
  bool outside = r >= a;
  float q = (outside ? a : r) / ((outside ? r : a) + root);
  bool tip = !outside && q < palpateRange[h].y;
  float begin = outside ? palpateRange[h].z : tip ? 0.0 : palpateRange[h].y;
  float end = tip ? palpateRange[h].y : 1.0;
  float intervals = palpateDraw[h].y;
  float t = intervals * clamp((q - begin) / (end - begin), 0.0, 1.0);
  float cell = min(floor(t), intervals - 1.0);
  int i = int((float(3 * h) + (outside ? 2.0 : tip ? 0.0 : 1.0)) * (intervals + 1.0) + cell);
  return mix(palpateTable[i], palpateTable[i + 1], t - cell);
}

// The local displacement of x with the normal n, and the turned normal.
vec3 palpateLocal(int h, vec3 x, vec3 n, out vec3 turned)
{
  vec3 normal = palpateNormal[h];
  vec4 range = palpateRange[h];
  vec4 draw = palpateDraw[h];
  vec3 chord = x - palpateContact[h];
  float height = dot(chord, normal);
  float cosine = dot(n, normal);
  float len = length(chord);
  float sine = (dot(n, chord) - cosine * height)
    / sqrt(max(len * len - height * height, 1e-12 * range.x * range.x));
  // r = chord (turn/2)/sin(turn/2), by the series of the arc sine: 2e-5 at 60 degrees.
  float square = 0.5 - 0.5 * cosine * inversesqrt(max(cosine * cosine + sine * sine, 1e-12));
  float arc = 1.0 + square * (0.16666667 + square * (0.075 + square * (0.04464286
    + square * (0.03038194 + square * 0.02237216))));
  float r = len * arc;
  vec3 away = chord - dot(chord, n) * n;
  float awayLength = length(away);
  bool apart = awayLength > 1e-6 * range.x;
  away = apart ? away / awayLength : vec3(0.0);

  vec4 law = palpateLaw(h, r);
#if PALPATE_NEAR
  vec3 sink = palpateSinkAt(h, r, away);
  law.y += sink.x;
  law.w += sink.y;
#endif
  float fading = range.w - draw.w;
  float t = clamp((r - draw.w) / fading, 0.0, 1.0);
  float turnedAway = clamp((cosine - 0.5) / (draw.z - 0.5), 0.0, 1.0);
  float share = turnedAway * turnedAway * (3.0 - 2.0 * turnedAway);
  vec2 u = share * (1.0 - t * t * (3.0 - 2.0 * t)) * law.xy;
  vec2 slope = draw.x * share
    * ((1.0 - t * t * (3.0 - 2.0 * t)) * law.zw - 6.0 * t * (1.0 - t) / fading * law.xy);
  float bend = sign(sine) * 2.0 * sqrt(max(square, 0.0)) / max(len, 1e-6 * range.x);
  vec3 along = (1.0 + slope.x) * away - draw.x * u.x * bend * n - slope.y * normal;
  bool moves = range.x > 0.0 && share > 0.0 && t < 1.0;
  vec3 across = cross(n, away);
#if PALPATE_NEAR
  across -= draw.x * share * (1.0 - t * t * (3.0 - 2.0 * t)) * sink.z * normal;
#endif
  turned = moves && apart ? normalize(cross(along, across)) : n;
  return moves ? u.x * away - u.y * normal : vec3(0.0);
}

// Dents add up, and so do, to first order, their turns of the normal n.
vec3 palpateDents(vec3 x, inout vec3 n)
{
  vec3 undented = n;
  vec3 sum = palpateLocal(0, x, undented, n);
  for (int h = 1; h < PALPATE_CONTACTS; ++h)
  {
    vec3 turned;
    sum += palpateLocal(h, x, undented, turned);
    n += turned - undented;
  }
  return sum;
}
)";

/// Uniforms with one value per contact. Only the size of these uniforms depends on the number of
/// contacts.
constexpr std::array<const char*, 9> PerContact = { "palpateNear", "palpateBend", "palpateTwist",
  "palpateStep", "palpateContact", "palpateNormal", "palpateRange", "palpateDraw", "palpateTable" };

/// The vertex is displaced first, so that all later code of VTK uses the displaced vertex. VTK's
/// variable for the texture coordinate of colours was called tcoord before VTK 9.3 and is called
/// colorTCoord since then.
std::string displacement(int modes)
{
  return std::string(R"(
  vec3 palpateNormalMC = palpateSurface;
  vec3 palpateU = palpateDents(vertexMC.xyz, palpateNormalMC);
)") +
    modeSum(modes, "palpateWeight", "palpateU", "palpateNormalMC", "palpateDraw[0].x") + R"(
  vec4 palpateVertexMC = vec4(vertexMC.xyz + palpateDraw[0].x * palpateU, vertexMC.w);
  vec2 palpateCoordinate = vec2(palpateColor.x + palpateColor.y * length(palpateU), palpateColor.z);
#define vertexMC palpateVertexMC
#define normalMC palpateNormalMC
#define tcoord palpateCoordinate
#define colorTCoord palpateCoordinate
)" + Beginning;
}

/// The values of the uniforms, contact by contact.
struct Uniforms
{
  using Three = std::array<float, 3>;
  using Four = std::array<float, 4>;

  std::vector<Four> near, bend, twist, range, draw, table;
  std::vector<Three> contact, normal;
  std::vector<float> step;
  std::array<float, 8> weights{}; // MostModes values, rounded up to a multiple of four

  void add(const DrawnDent& dent, double exaggeration);
  void give(vtkUniforms* uniforms) const;
};

float number(double value)
{
  return static_cast<float>(value);
}

Uniforms::Three numbers(const Vector3& vector)
{
  return { number(vector[0]), number(vector[1]), number(vector[2]) };
}

void Uniforms::add(const DrawnDent& dent, double exaggeration)
{
  const ContactField& field = dent.field;
  const double reach = DeflectionShader::reachOf(field);
  const DeflectionTable sampled(field, reach, dent.edge);
  const NearField& known = field.nearField();
  this->near.push_back({ number(known.slope[0]), number(known.slope[1]), number(known.slope[2]),
    number(known.depth) });
  this->bend.push_back({ number(known.bend(0, 0)), number(known.bend(1, 1)),
    number(known.bend(2, 2)), number(known.radius) });
  this->twist.push_back({ number(known.bend(0, 1)), number(known.bend(1, 2)),
    number(known.bend(2, 0)), number(field.nearDepth()) });
  this->step.push_back(number(dent.edge));
  this->contact.push_back(numbers(dent.contact.point));
  this->normal.push_back(numbers(dent.contact.normal));
  this->range.push_back({ sampled.radius, sampled.kink, sampled.far, number(reach) });
  this->draw.push_back({ number(exaggeration), number(DeflectionTable::Intervals),
    number(ContactField::CosineOfFade), number(ContactField::FadeBegin * reach) });
  this->table.insert(this->table.end(), sampled.nodes.begin(), sampled.nodes.end());
  for (std::size_t k = 0; k < field.modeWeights().size() && k < MostModes; ++k)
  {
    this->weights[k] += number(field.modeWeights()[k]);
  }
}

void Uniforms::give(vtkUniforms* uniforms) const
{
  const auto give3 = [uniforms](const char* name, const std::vector<Three>& values)
  {
    uniforms->SetUniform3fv(
      name, static_cast<int>(values.size()), reinterpret_cast<const float(*)[3]>(values.data()));
  };
  const auto give4 = [uniforms](const char* name, const std::vector<Four>& values)
  {
    uniforms->SetUniform4fv(
      name, static_cast<int>(values.size()), reinterpret_cast<const float(*)[4]>(values.data()));
  };
  give4("palpateNear", this->near);
  give4("palpateBend", this->bend);
  give4("palpateTwist", this->twist);
  give4("palpateRange", this->range);
  give4("palpateDraw", this->draw);
  give4("palpateTable", this->table);
  give3("palpateContact", this->contact);
  give3("palpateNormal", this->normal);
  uniforms->SetUniform1fv("palpateStep", static_cast<int>(this->step.size()), this->step.data());
  uniforms->SetUniform1fv("palpateWeight", 8, this->weights.data());
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

void DeflectionShader::install(const Code& code)
{
  if (this->IsInstalled && this->Installed == code)
  {
    return;
  }
  this->remove();
  this->IsInstalled = true;
  this->Installed = code;
  // All uniforms are set here, because VTK declares a uniform when it is first set.
  setColors(this->Property, 0.0F, 0.0F, 0.0F);
  this->show({}, 1.0);
  const std::string choice = "\n#define PALPATE_CONTACTS " + std::to_string(code.contacts) +
    "\n#define PALPATE_NEAR " + (code.hasNearField ? "1" : "0");
  this->Property->AddVertexShaderReplacement(
    Declarations, true, choice + Functions + modeDeclarations(code.modes) + Declarations, false);
  this->Property->AddVertexShaderReplacement(Beginning, true, displacement(code.modes), false);
}

void DeflectionShader::remove()
{
  if (!this->IsInstalled)
  {
    return;
  }
  this->Property->ClearVertexShaderReplacement(Declarations, true);
  this->Property->ClearVertexShaderReplacement(Beginning, true);
  for (const char* name : PerContact)
  {
    this->Property->GetVertexCustomUniforms()->RemoveUniform(name);
  }
  this->IsInstalled = false;
}

void DeflectionShader::show(const std::vector<DrawnDent>& dents, double exaggeration)
{
  Uniforms uniforms;
  for (std::size_t i = 0; i < static_cast<std::size_t>(this->Installed.contacts); ++i)
  {
    uniforms.add(i < dents.size() ? dents[i] : DrawnDent(), exaggeration);
  }
  uniforms.give(this->Property->GetVertexCustomUniforms());
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
  this->BoundsMargin = around;
}

void DentMapper::ComputeBounds()
{
  this->Superclass::ComputeBounds();
  if (this->BoundsMargin >= 0.0 && vtkBoundingBox(this->Bounds).IsValid())
  {
    vtkBoundingBox box(this->Bounds);
    box.Inflate(this->BoundsMargin);
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

// The mapper makes a texture of the lookup table. Only the mapper can convert a value to its
// texture coordinate. Therefore this function lets the mapper convert the two ends of the range.
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

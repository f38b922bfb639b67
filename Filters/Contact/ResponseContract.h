// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The data contract: names, content and meaning of the arrays of a response. All code that reads,
 * writes, copies or checks these arrays uses this table; `palpate.contract` is tested against it.
 */
#ifndef palpate_ResponseContract_h
#define palpate_ResponseContract_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace palpate
{
/// Status of the response of one point.
enum class ResponseStatus : std::uint8_t
{
  Valid,
  Degenerate,
  NotFinite,
  Folded,
  OutOfReach,
  Edge ///< the response is interpolated from the neighbours of the point; it can be used
};

/// The assumption of the law that breaks first at a point. These are the codes of the array
/// `Limit`.
enum class ResponseLimit : std::uint8_t
{
  None, ///< the law holds up to Range
  Strain,
  Curvature,
  Thickness,
  OppositeWall,
  Edge,
  DataEnd,
  Elements, ///< the finite elements from which the response was computed
  Tilt      ///< tilt of the tool on a body other than a half-space
};
constexpr std::size_t ResponseLimitCount = 9;

/// Returns the name of a limit: "strain", "layer thickness"; "" for 0 and for unknown codes. The
/// text is static.
PALPATE_EXPORT const char* limitInWords(int code) noexcept;

/// Returns the name of an assumption: "small strain", "a flat surface"; "" for 0 and for unknown
/// codes. The text is static.
PALPATE_EXPORT const char* assumptionInWords(int code) noexcept;

/// Returns the name of a ContactState: "contact, sliding"; "unknown" for unknown codes. The text is
/// static.
PALPATE_EXPORT const char* contactInWords(int state) noexcept;

/// Returns a remark about a ContactState: a sentence without its full stop; "" for a normal
/// contact. The text is static.
PALPATE_EXPORT const char* contactRemark(int state) noexcept;

/// The parts of a response's model; their sum is in the array `ModelParts`. The text `Model`
/// describes the same parts in words; it is parsed only for old files.
enum ModelPart : int
{
  HalfSpacePart = 1,
  LayerPart = 2,
  GlobalCompliancePart = 4, ///< the global compliance of the body, in series
  SpringPart = 8,           ///< a spring at each point, independent of the tool
  StackPart = 16,           ///< several layers on each other
  FiniteStrainPart = 32,
  CurvaturePart = 64, ///< the body's curvature
  TrueShapePart = 128 ///< finite elements of the whole body, for each point
};

/// Derives the model parts of a response that was saved without them from its text `Model`. Returns
/// 0 if they are unknown.
PALPATE_EXPORT int modelPartsOfText(const std::string& model);

/// The arrays of a response, in the order of the table.
enum class ResponseArray : std::uint8_t
{
  Force,
  Stiffness,
  Coefficient,
  Basis,
  Normal,
  Range,
  Status,
  Validity,
  Limit,
  Error,
  Samples,
  Exponent,
  Tool,
  Model,
  ModelParts,
  Units,
  Edges,
  RelaxationStrength,
  RelaxationTime,
  LocalRelaxation,
  ElasticCompliance,
  Coupling,
  CouplingModulus,
  CouplingThickness,
  CouplingModes,
  Tilt,
  TiltDrop,
  TiltNode,
  TiltWeight,
  LayerThickness,
  LayerBase,
  LayerStack,
  SecondThickness,
  Terms,
  Choice,
  RelaxationElements,
  Reduction,
  ReductionError,
  ShapeChange,
  SurfaceError,
  Direct
};

/// One array of a response. Its name is the name of the response followed by `suffix`.
struct ContractArray
{
  /// Whether the array is point data or field data.
  enum class Place : std::uint8_t
  {
    Points,
    Fields
  };
  /// Type of the values.
  enum class Type : std::uint8_t
  {
    Float,
    Double,
    Int,
    UnsignedChar,
    Text
  };
  /// Number of components of a tuple.
  enum class Width : std::uint8_t
  {
    One,
    Two,
    Three,
    Four,
    Five,
    Seven,
    Samples,
    TwoSamples, ///< forces, then stiffnesses; one tuple per law
    Laws,
    Branches, ///< branches of the relaxation; a field array has one tuple per branch
    Modes,    ///< modes of the body, at most CouplingTerms::MostModes
    TiltLaws  ///< laws of the table of tilts
  };
  /// Purpose of the array.
  enum class Use : std::uint8_t
  {
    Evaluation, ///< needed to evaluate curves in both forms
    PerPoint,   ///< needed to evaluate curves if each point has a separate curve
    Compact,    ///< needed to evaluate curves that are combinations of laws
    Trust,      ///< the depth up to which the law holds
    Words,      ///< texts that describe the response
    Edges,      ///< terms for contacts over sharp edges; may be absent
    Relaxation, ///< terms for the relaxation of the body; may be absent
    Coupling,   ///< terms for the coupling of contacts; may be absent
    Tilt,       ///< terms for the effect of tilting the tool; may be absent
    Layers,     ///< the layers under each point, for the displacement field; may be absent
    Remark      ///< texts about the choice, reduction or comparison of the response; may be absent
  };

  ResponseArray array;
  const char* suffix;
  Place place;
  Type type;
  Width width;
  Use use;
  const char* unit; ///< "" for a dimensionless number
  const char* meaning;

  bool isEvaluated() const noexcept
  {
    return this->use != Use::Trust && this->use != Use::Words && this->use != Use::Layers &&
      this->use != Use::Remark;
  }
  std::string named(const std::string& response) const { return response + this->suffix; }
};

// clang-format off
constexpr std::array<ContractArray, 41> ResponseContract = { {
#define PALPATE_ARRAY(name, place, type, width, use, unit, meaning)                                \
  { ResponseArray::name, #name, ContractArray::Place::place, ContractArray::Type::type,            \
    ContractArray::Width::width, ContractArray::Use::use, unit, meaning }
  PALPATE_ARRAY(Force,       Points, Float,        Samples,    PerPoint,   "N",    "F at the samples"),
  PALPATE_ARRAY(Stiffness,   Points, Float,        Samples,    PerPoint,   "N/mm", "dF/d\u03b4 at the samples"),
  PALPATE_ARRAY(Coefficient, Points, Float,        Laws,       Compact,    "",     "curve = sum of coefficient times law"),
  PALPATE_ARRAY(Basis,       Fields, Float,        TwoSamples, Compact,    "N",    "the laws: forces, then stiffnesses"),
  PALPATE_ARRAY(Normal,      Points, Float,        Three,      Evaluation, "",     "unit normal, outward"),
  PALPATE_ARRAY(Range,       Points, Float,        One,        Evaluation, "mm",   "deflection of the last sample"),
  PALPATE_ARRAY(Status,      Points, UnsignedChar, One,        Evaluation, "",     "ResponseStatus"),
  PALPATE_ARRAY(Validity,    Points, Float,        One,        Trust,      "mm",   "depth at which the first assumption breaks"),
  PALPATE_ARRAY(Limit,       Points, UnsignedChar, One,        Trust,      "",     "ResponseLimit: which one"),
  PALPATE_ARRAY(Error,       Points, Float,        Samples,    Trust,      "",     "estimated relative error of F at the samples; optional"),
  PALPATE_ARRAY(Samples,     Fields, Int,          One,        Evaluation, "",     "samples of a curve, n"),
  PALPATE_ARRAY(Exponent,    Fields, Double,       One,        Evaluation, "",     "m of F = \u03b4^m r(s)"),
  PALPATE_ARRAY(Tool,        Fields, Text,         One,        Words,      "",     "the tool's specification"),
  PALPATE_ARRAY(Model,       Fields, Text,         One,        Words,      "",     "the model, to be read"),
  PALPATE_ARRAY(ModelParts,  Fields, UnsignedChar, One,        Words,      "",     "sum of ModelPart"),
  PALPATE_ARRAY(Units,       Fields, Text,         One,        Words,      "",     "\"mm,N,MPa\""),
  PALPATE_ARRAY(Edges,       Fields, Double,       Five,       Edges,      "",     "EdgeTerms: m, contact radius at 1 mm (mm), \u03bd, extent (mm), 1 if in the curves"),
  PALPATE_ARRAY(RelaxationStrength, Fields, Double, Branches, Relaxation, "", "p_i of E(t)/E_\u221e = 1 + \u03a3 p_i exp(-t/\u03c4_i); the curves are the slow response"),
  PALPATE_ARRAY(RelaxationTime,     Fields, Double, Branches, Relaxation, "s", "\u03c4_i"),
  PALPATE_ARRAY(LocalRelaxation,    Points, Float,  Branches, Relaxation, "", "p_i of each point, instead of RelaxationStrength"),
  PALPATE_ARRAY(ElasticCompliance,  Points, Float,  One,      Relaxation, "mm/N", "what is in series and does not relax"),
  PALPATE_ARRAY(Coupling,          Fields, Double, Three, Coupling, "", "CouplingTerms: E* (MPa), layer (mm; 0: half-space), 0; of a layer then 79 CouplingKnots: g, its slope, a/h"),
  PALPATE_ARRAY(CouplingModulus,   Points, Float,  One,   Coupling, "MPa", "E* of each point, where it varies"),
  PALPATE_ARRAY(CouplingThickness, Points, Float,  One,   Coupling, "mm", "the layer of each point, where it varies"),
  PALPATE_ARRAY(CouplingModes,     Points, Float,  Modes, Coupling, "\u221a(mm/N)", "\u03c6_m of C_ij = \u03a3 \u03c6_m(i) \u03c6_m(j), inward along the normal"),
  PALPATE_ARRAY(Tilt,       Fields, Double, Seven,    Tilt, "", "TiltTerms: range (mm), largest tilt (rad), scale of the drop, numbers of depths, angles, drops, laws"),
  PALPATE_ARRAY(TiltDrop,   Fields, Double, Two,      Tilt, "mm", "of each tilt: drop of the tool's deepest point, and its derivative by the tilt (rad)"),
  PALPATE_ARRAY(TiltNode,   Fields, Double, Four,     Tilt, "", "of each law, depth, angle: work over that of the upright tool, and its derivatives by x, y, both"),
  PALPATE_ARRAY(TiltWeight, Points, Float,  TiltLaws, Tilt, "", "of each law at the point, sum 1; absent: one law"),
  PALPATE_ARRAY(LayerThickness,     Points, Float,        One,  Layers, "mm", "the top layer; 0: a half-space"),
  PALPATE_ARRAY(LayerBase,          Fields, UnsignedChar, One,  Layers, "",   "0 bonded to a rigid base, 1 slipping on it"),
  PALPATE_ARRAY(LayerStack,         Fields, Double,       Four, Layers, "",   "of each layer of a stack: thickness (mm; 0: half-space), E (MPa), \u03bd, 1 if it slips below the layer above"),
  PALPATE_ARRAY(SecondThickness,    Points, Float,        One,  Layers, "mm", "the second layer of a stack"),
  PALPATE_ARRAY(Terms,              Fields, Text,         One,  Remark, "",   "the terms of the law that were kept and left out, and why"),
  PALPATE_ARRAY(Choice,             Fields, Text,         One,  Remark, "",   "the form that vtkResponseChoice chose, and why"),
  PALPATE_ARRAY(RelaxationElements, Fields, Int,          One,  Remark, "",   "the number of elements that its tolerance needs"),
  PALPATE_ARRAY(Reduction,          Fields, Text,         One,  Remark, "",   "the form that vtkReducedContactResponse found"),
  PALPATE_ARRAY(ReductionError,     Fields, Double,       One,  Remark, "",   "its largest relative error of the force"),
  PALPATE_ARRAY(ShapeChange,        Points, Float,        One,  Remark, "",   "largest relative change of the force by true shape"),
  PALPATE_ARRAY(SurfaceError,       Points, Float,        One,  Remark, "",   "relative change of the force by unknown detail of the surface"),
  PALPATE_ARRAY(Direct,             Points, UnsignedChar, One,  Remark, "",   "outcome of vtkDirectContactResponse"),
#undef PALPATE_ARRAY
} };
// clang-format on

constexpr const ContractArray& contractOf(ResponseArray array)
{
  std::size_t place = 0;
  while (ResponseContract[place].array != array)
  {
    ++place;
  }
  return ResponseContract[place];
}

/// Returns the name of an array of a response.
inline std::string arrayName(const std::string& response, ResponseArray array)
{
  return contractOf(array).named(response);
}

/// Returns the number of components of a tuple of the array, for a response with these numbers of
/// samples, laws, branches of the relaxation, modes of the body, and laws of the table of tilts.
constexpr int componentsOf(const ContractArray& array, int samples, int laws, int branches = 0,
  int modes = 0, int tiltLaws = 0)
{
  switch (array.width)
  {
    case ContractArray::Width::Two:
      return 2;
    case ContractArray::Width::Four:
      return 4;
    case ContractArray::Width::Seven:
      return 7;
    case ContractArray::Width::Three:
      return 3;
    case ContractArray::Width::Five:
      return 5;
    case ContractArray::Width::Samples:
      return samples;
    case ContractArray::Width::TwoSamples:
      return 2 * samples;
    case ContractArray::Width::Laws:
      return laws;
    case ContractArray::Width::Branches:
      return array.place == ContractArray::Place::Points ? branches : 1;
    case ContractArray::Width::TiltLaws:
      return tiltLaws;
    case ContractArray::Width::Modes:
      return modes;
    default:
      return 1;
  }
}
} // namespace palpate

#endif

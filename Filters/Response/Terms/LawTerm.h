// SPDX-License-Identifier: BSD-3-Clause
#ifndef LawTerm_h
#define LawTerm_h

#include "palpateResponseModule.h" // For export macro

#include "Response/BodyLaws.h" // For palpate::LawRequest

#include <array>  // For std::array
#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
class AutomaticTerms;
class AxisymmetricTool;
struct ResponseArrays;
struct ResponseModel;

/// Properties of the response to which a term belongs.
struct TermBody
{
  /// Request of the response; it is valid, except for the settings that LawTerm::check checks.
  const LawRequest& request;
  const AxisymmetricTool& tool; ///< tool of the request
  /// Material; null for a response that finite elements compute for the true shape.
  const BodyMaterial* material;
  double depth = 0.0; ///< upper limit of the depth of the body, mm
};

/**
 * A term of a response. Terms extend the law of the tool on a flat half-space at small strain. The
 * extensions are layers, curvature, edges, finite strain, relaxation, coupling and tilt. The class
 * of a term contains all code of the term, except the code of a tick. Code that creates, reads,
 * writes or describes responses loops over lawTerms(). A term without arrays, description or error
 * does not override the corresponding function. Immutable.
 */
class PALPATERESPONSE_EXPORT LawTerm
{
public:
  virtual ~LawTerm() = default;

  virtual bool isAsked(const LawRequest& request) const = 0;

  /// Checks the settings of the term, whether or not the term is requested. Also checks the arrays
  /// of the term on this rank's piece of the body; null means a body without arrays. The range of
  /// the material is the range over the whole body. Returns "" or an error that names the setting
  /// or the array.
  virtual std::string check(const TermBody& response, vtkPolyData* piece) const;

  /// Attaches the arrays of the term to a body that has its curves and no older arrays of the term.
  /// The function is called only if the term is requested. Returns "" or an error message.
  virtual std::string make(const TermBody& response, vtkPolyData* output) const;

  /// Adds the error of the term to the validity and the error of the response. Called after make().
  /// The errors of layers, curvature, edges and strain are part of the curves (ErrorRule) and are
  /// not added here.
  virtual std::string limit(const TermBody& response, vtkPolyData* output) const;

  /// Returns the text and the ModelPart that describe a requested term in the model of the
  /// response. The text begins with a comma.
  virtual ResponseModel words(const TermBody& response) const;

  /// Removes the term from `choice` or adds it to `choice`, such that the forces stay within the
  /// tolerance. Adds the reason to `choice`. Collective. Returns "" or an error message.
  virtual std::string need(AutomaticTerms& choice) const;

  /// Sets the views of the term's arrays. Leaves the views unchanged if the body does not have
  /// these arrays. The views of the curves must already be set. Returns false and an error that
  /// names the array and the number.
  virtual bool view(
    vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error) const;

  /// Attaches copies of the arrays that the views of the term refer to. Attaches nothing if the
  /// term has no views.
  virtual void describe(
    vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const;
};

/// The terms. Each is defined in the source file of the same name.
const LawTerm& layerTerm();
const LawTerm& curvatureTerm();
const LawTerm& edgeTerm();
const LawTerm& strainTerm();
const LawTerm& relaxationTerm();
const LawTerm& couplingTerm();
const LawTerm& tiltTerm();

/// Returns all terms, in the order in which they are checked, created and described.
PALPATERESPONSE_EXPORT const std::array<const LawTerm*, 7>& lawTerms();

/// Returns the first fault that LawTerm::check finds in any term; "" if there is none.
PALPATERESPONSE_EXPORT std::string checkTerms(const TermBody& response, vtkPolyData* piece);

/// Attaches the arrays of all requested terms, and adds the errors of these terms. Call the
/// function after the curves are attached. Returns "" or an error message.
PALPATERESPONSE_EXPORT std::string makeTerms(const TermBody& response, vtkPolyData* output);

/// Returns the concatenated texts of all requested terms and the sum of their ModelParts.
PALPATERESPONSE_EXPORT ResponseModel termsInWords(const TermBody& response);
} // namespace palpate

#endif

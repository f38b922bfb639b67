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
  const LawRequest& request;    ///< valid, except for the settings that LawTerm::check checks
  const AxisymmetricTool& tool; ///< tool of the request
  const BodyMaterial* material; ///< null for a response by finite elements of the true shape
  double depth = 0.0;           ///< upper limit of the depth of the body, mm
};

/**
 * A term of a response. Terms extend the law of the tool on a flat half-space at small strain by:
 * layers, curvature, edges, finite strain, relaxation, coupling, tilt. The class of a term contains
 * all code of the term, except the code of a tick. Code that makes, reads, writes or describes
 * responses loops over lawTerms(). A term that has no arrays, words or error does not override the
 * corresponding function. Immutable.
 */
class PALPATERESPONSE_EXPORT LawTerm
{
public:
  virtual ~LawTerm() = default;

  virtual bool isAsked(const LawRequest& request) const = 0;

  /// Checks the settings of the term, whether or not the term is requested, and the arrays of this
  /// rank's piece of the body (null: a body without arrays). The range of the material is that of
  /// the whole body. Returns "" or an error that names the setting or the array.
  virtual std::string check(const TermBody& response, vtkPolyData* piece) const;

  /// Attaches the arrays of the term to a body that has its curves and no older arrays of the term.
  /// Called if the term is requested. Returns "" or an error message.
  virtual std::string make(const TermBody& response, vtkPolyData* output) const;

  /// Includes the error of the term in the validity and the error of the response. Called after
  /// make. The errors of layers, curvature, edges and strain are part of the curves (ErrorRule) and
  /// are not added here.
  virtual std::string limit(const TermBody& response, vtkPolyData* output) const;

  /// Returns the text and the ModelPart with which the model of the response describes a requested
  /// term. The text begins with a comma.
  virtual ResponseModel words(const TermBody& response) const;

  /// Removes the term from `choice` or adds it to `choice`, so that the forces stay within the
  /// tolerance. Adds the reason. Collective. Returns "" or an error message.
  virtual std::string need(AutomaticTerms& choice) const;

  /// Sets the views of the term's arrays. Leaves the views unchanged if the body has no such
  /// arrays. The views of the curves must be set. Returns false and an error that names array and
  /// number.
  virtual bool view(
    vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error) const;

  /// Attaches copies of the viewed arrays of the term. Attaches nothing if the term has no views.
  virtual void describe(
    vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const;
};

/// The terms. Each is defined in the file of its name.
const LawTerm& layerTerm();
const LawTerm& curvatureTerm();
const LawTerm& edgeTerm();
const LawTerm& strainTerm();
const LawTerm& relaxationTerm();
const LawTerm& couplingTerm();
const LawTerm& tiltTerm();

/// All terms, in the order in which they are checked, made and described.
PALPATERESPONSE_EXPORT const std::array<const LawTerm*, 7>& lawTerms();

/// Returns the first fault that LawTerm::check finds in any term, or "".
PALPATERESPONSE_EXPORT std::string checkTerms(const TermBody& response, vtkPolyData* piece);

/// Attaches the arrays of all requested terms, and includes their errors. Call it after the curves
/// are attached. Returns "" or an error message.
PALPATERESPONSE_EXPORT std::string makeTerms(const TermBody& response, vtkPolyData* output);

/// Returns the texts of all requested terms, one after the other, and the sum of their ModelParts.
PALPATERESPONSE_EXPORT ResponseModel termsInWords(const TermBody& response);
} // namespace palpate

#endif

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

/// The response for which a term is made.
struct TermBody
{
  const LawRequest& request;    ///< without fault, except in the settings that LawTerm::check reads
  const AxisymmetricTool& tool; ///< that of the request
  const BodyMaterial* material; ///< null: finite elements of the true shape
  double depth = 0.0;           ///< mm: the body is nowhere deeper
};

/**
 * A term of a response, in addition to the law of the tool on a flat half-space at small strain:
 * layers, curvature, edges, finite strain, relaxation, coupling, tilt. All code of a term outside
 * of a tick is in its class; what makes, reads, writes or describes responses goes over lawTerms().
 * A term without arrays, words or error does not override the function for them. Immutable.
 */
class PALPATERESPONSE_EXPORT LawTerm
{
public:
  virtual ~LawTerm() = default;

  virtual bool isAsked(const LawRequest& request) const = 0;

  /// Checks the settings of the term, asked or not, and the arrays of this rank's piece of the
  /// body (null: a body without arrays). The range of the material is that of the whole body.
  /// Returns "" or an error that names the setting or the array.
  virtual std::string check(const TermBody& response, vtkPolyData* piece) const;

  /// Attaches the arrays of the term to a body that has its curves and no older arrays of the term.
  /// Called if the term is asked. Returns "" or an error message.
  virtual std::string make(const TermBody& response, vtkPolyData* output) const;

  /// Includes the error of the term in validity and error of the response; called after make. The
  /// errors of layers, curvature, edges and strain are part of the curves (ErrorRule).
  virtual std::string limit(const TermBody& response, vtkPolyData* output) const;

  /// What the model of the response says of a term that is asked: its text, which begins with a
  /// comma, and its ModelPart.
  virtual ResponseModel words(const TermBody& response) const;

  /// Leaves the term out of `choice`, or adds it, as the tolerance of the forces needs, and adds
  /// the reason. Collective. Returns "" or an error message.
  virtual std::string need(AutomaticTerms& choice) const;

  /// Sets the views of the arrays of the term; leaves them unchanged if the body has none. The
  /// curves must be set. Returns false and an error that names array and number.
  virtual bool view(
    vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error) const;

  /// Attaches copies of the views as arrays; nothing if they have no such term.
  virtual void describe(
    vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const;
};

/// The terms, each in the file of its name.
const LawTerm& layerTerm();
const LawTerm& curvatureTerm();
const LawTerm& edgeTerm();
const LawTerm& strainTerm();
const LawTerm& relaxationTerm();
const LawTerm& couplingTerm();
const LawTerm& tiltTerm();

/// All terms, in the order in which they are checked, made and described.
PALPATERESPONSE_EXPORT const std::array<const LawTerm*, 7>& lawTerms();

/// The first fault that LawTerm::check finds, or "".
PALPATERESPONSE_EXPORT std::string checkTerms(const TermBody& response, vtkPolyData* piece);

/// Attaches the terms that are asked, after the curves, and includes their errors. Returns "" or an
/// error message.
PALPATERESPONSE_EXPORT std::string makeTerms(const TermBody& response, vtkPolyData* output);

/// The words of the terms that are asked, one after the other, and the sum of their parts.
PALPATERESPONSE_EXPORT ResponseModel termsInWords(const TermBody& response);
} // namespace palpate

#endif

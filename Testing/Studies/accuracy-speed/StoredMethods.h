// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "Contact/ContactSettings.h"
#include "StudyBody.h"
#include "StudyLaw.h"

#include <memory>
#include <string>

/// Responses stored at each point and interpolated in the tick.
namespace palpate::testing
{
/// Palpate's own kernel, ToolContact: cubic Hermite interpolation in √δ of forces and stiffnesses,
/// float32.
std::unique_ptr<ContactMethod> hermite(const std::string& name, const StudyBody& body,
  const SampledCurves& curves, ContactSurface surface = ContactSurface::Facets);

/// ToolContact with the compact form of the response, with the fewest numbers per point that keep
/// the curves within `tolerance`.
std::unique_ptr<ContactMethod> reducedBasis(
  const std::string& name, const StudyBody& body, const SampledCurves& curves, double tolerance);

/// Linear interpolation between the same samples (and 0 at the surface), float32, without
/// stiffnesses.
std::unique_ptr<ContactMethod> linear(
  const std::string& name, const StudyBody& body, const SampledCurves& curves);

enum class FloatWidth
{
  Half = 16,
  Single = 32,
  Double = 64
};
/// The Hermite form with samples of another width; evaluated by ResponseSampling.
std::unique_ptr<ContactMethod> hermiteIn(
  FloatWidth width, const std::string& name, const StudyBody& body, const SampledCurves& curves);
} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolContact_h
#define palpate_ToolContact_h

#include "ContactBody.h"
#include "ContactTracker.h"

#include <cstdint>

namespace palpate
{
enum class ContactState : std::uint8_t
{
  None,
  Stick,
  Slide,
  BeyondRange,
  LostAtBorder,
  Invalid
};

enum class ForceForm : std::uint8_t
{
  /// Σ n_i f_i U_i (Mahvash and Hayward 2002, eq. 3). The sum of unit normals is shorter than 1, so
  /// the force loses about h²/(6 R²) in the middle of a facet of size h on a body of radius R.
  Paper,
  /// (Σ n_i f_i) along the normalised Σ n_i U_i: magnitude and direction blended apart.
  NormalizedDirection
};

/// What the tool feels in one tick. Body frame; mm, N, N/mm.
struct ToolContactForce
{
  ContactState state = ContactState::None;
  Vector3 force = Vector3::Zero(); ///< total, on the tool
  Vector3 friction = Vector3::Zero();
  double normalForce = 0.0;
  double stiffness = 0.0; ///< Σ n_i dF_i/dδ
  double deflection = 0.0;
  Vector3 normal = Vector3::Zero(); ///< blended unit normal used
  Vector3 contactPoint = Vector3::Zero();
  std::int32_t triangle = -1;
};

/**
 * One tick: tip position in, contact force out.
 *
 * The tip is projected on the undeformed surface (ContactTracker), its distance is the deflection
 * δ, and the curves of the triangle's three vertices are blended with the area coordinates n_i of
 * the projection (Mahvash and Hayward 2002, eqs. 3 and 4). Frictionless: a contact slides.
 *
 * update() neither allocates nor locks nor throws. One ToolContact is one history and serves one
 * thread; the body may be shared and must outlive it.
 */
class ToolContact
{
public:
  explicit ToolContact(const ContactBody& body, ForceForm form = ForceForm::NormalizedDirection)
    : Body(body)
    , Tracker(body.surface, body.tree)
    , Form(form)
  {
  }

  ToolContactForce update(const Vector3& tip) noexcept;
  void reset() noexcept { this->Tracker.reset(); }

private:
  ToolContactForce blend(const SurfacePoint& surface) const noexcept;

  const ContactBody& Body;
  ContactTracker Tracker;
  ForceForm Form;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "SessionSettings.h"

#include "vtkHapticSession.h"

#include <sstream>

namespace palpate
{
void chooseContact(const ViewerOptions& options, const TouchScene& scene, vtkHapticSession* session)
{
  const GivenSettings& contact = options.contact;
  session->SetForceForm(contact.forceForm);
  session->SetContactSurface(contact.contactSurface);
  session->SetFrictionCoefficient(contact.frictionCoefficient);
  session->SetFrictionModel(contact.frictionModel);
  session->SetTangentialStiffness(contact.tangentialStiffness);
  session->SetPoissonRatio(scene.poissonsRatio);
}

std::string describeFriction(const ViewerOptions& options, const TouchScene& scene)
{
  const GivenSettings& contact = options.contact;
  if (contact.frictionCoefficient == 0.0)
  {
    return {};
  }
  std::ostringstream text;
  text << "mu = " << contact.frictionCoefficient << ", ";
  if (contact.frictionModel == static_cast<int>(FrictionModel::ShapeDerived))
  {
    text << "stuck as shape and depth of the contact tell, nu = " << scene.poissonsRatio;
  }
  else
  {
    const bool creeps = contact.frictionModel == static_cast<int>(FrictionModel::Dahl);
    text << (creeps ? "Dahl's creep, " : "elasto-plastic, ") << contact.tangentialStiffness
         << " N/mm";
  }
  return text.str();
}
} // namespace palpate

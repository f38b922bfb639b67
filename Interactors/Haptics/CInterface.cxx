// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/CInterface.h"

#include "Contact/FlatBodyFile.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <string_view>

namespace palpate::c
{
namespace
{
/// "FrictionCoefficient" → "friction_coefficient".
std::string nameInC(const std::string& property)
{
  std::string name;
  for (const char letter : property)
  {
    const bool isCapital = letter >= 'A' && letter <= 'Z';
    name += isCapital && !name.empty() ? "_" : "";
    name += isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return name;
}
} // namespace

void report(const std::string& reason, char* error, std::size_t size)
{
  if (error && size > 0)
  {
    std::snprintf(error, size, "%s", reason.c_str());
  }
}

bool isRefused(const SettingFault& fault, char* error, std::size_t size)
{
  if (fault)
  {
    report(nameInC(fault.name) + ' ' + fault.remark, error, size);
  }
  return static_cast<bool>(fault);
}

ContactSettings given(const palpate_settings& settings)
{
  ContactSettings given;
  given.form = static_cast<ForceForm>(settings.force_form);
  given.surface = static_cast<ContactSurface>(settings.contact_surface);
  given.friction = { static_cast<FrictionModel>(settings.friction_model),
    settings.friction_coefficient, settings.tangential_stiffness, settings.friction_breakaway,
    settings.friction_stick_radius, settings.poisson_ratio };
  return given;
}

void copy(const Eigen::Vector3d& from, double to[3])
{
  std::copy_n(from.data(), 3, to);
}

void copy(const Tick& felt, palpate_tick* tick)
{
  copy(felt.deviceForce, tick->device_force);
  copy(felt.tip, tick->tip);
  copy(felt.contact.force, tick->force);
  copy(felt.contact.friction, tick->friction);
  tick->normal_force = felt.contact.normalForce;
  tick->deflection = felt.contact.deflection;
  copy(felt.contact.normal, tick->normal);
  copy(felt.contact.contactPoint, tick->contact_point);
  tick->triangle = felt.contact.triangle;
  tick->state = static_cast<int>(felt.contact.state);
  tick->memory = felt.contact.memory;
  copy(felt.contact.torque, tick->torque);
  tick->tilt = felt.contact.tilt;
  std::fill(std::begin(tick->reserved), std::end(tick->reserved), 0.0);
}
} // namespace palpate::c

// C programs may copy the header, so its version is written there, not by CMake.
#define PALPATE_TEXT_OF(number) #number
#define PALPATE_TEXT(number) PALPATE_TEXT_OF(number)
static_assert(std::string_view(PALPATE_VERSION_STRING) ==
    PALPATE_TEXT(PALPATE_VERSION_MAJOR) "." PALPATE_TEXT(PALPATE_VERSION_MINOR) "." PALPATE_TEXT(
      PALPATE_VERSION_PATCH),
  "palpate.h: its version's text and numbers");
static_assert(std::string_view(PALPATE_VERSION_STRING) == PALPATE_PROJECT_VERSION,
  "palpate.h: its version is not the project's in CMakeLists.txt");

const char* palpate_version(void)
{
  return PALPATE_VERSION_STRING;
}

int palpate_api_version(void)
{
  return PALPATE_API_VERSION;
}

palpate_body* palpate_body_load(const char* path, char* error, std::size_t error_size)
{
  try
  {
    palpate::FlatBodyFile file;
    const std::string fault = path ? file.open(path) : "no path is given";
    if (fault.empty())
    {
      return new palpate_body{ palpate::makeContactBody(file.body()) };
    }
    palpate::c::report(fault, error, error_size);
  }
  catch (const std::exception& failure)
  {
    palpate::c::report(std::string("cannot load the body: ") + failure.what(), error, error_size);
  }
  return nullptr;
}

void palpate_body_free(palpate_body* body)
{
  delete body;
}

palpate_contact* palpate_contact_new(const palpate_body* body, double maximum_force)
{
  return palpate_contact_new_with(body, maximum_force, nullptr, nullptr, 0);
}

void palpate_settings_default(palpate_settings* settings)
{
  const palpate::ContactSettings usual;
  *settings = {};
  settings->force_form = static_cast<int>(usual.form);
  settings->contact_surface = static_cast<int>(usual.surface);
  settings->friction_model = static_cast<int>(usual.friction.model);
  settings->friction_coefficient = usual.friction.coefficient;
  settings->tangential_stiffness = usual.friction.tangentialStiffness;
  settings->friction_breakaway = usual.friction.breakaway;
  settings->friction_stick_radius = usual.friction.stickRadius;
  settings->poisson_ratio = usual.friction.poissonRatio;
}

palpate_contact* palpate_contact_new_with(const palpate_body* body, double maximum_force,
  const palpate_settings* settings, char* error, size_t error_size)
{
  try
  {
    const palpate::ContactSettings wanted =
      settings ? palpate::c::given(*settings) : palpate::ContactSettings();
    if (!body)
    {
      palpate::c::report("no body is given", error, error_size);
    }
    else if (!(settings &&
               palpate::c::isFromLater(
                 settings->reserved, "palpate_settings", error, error_size)) &&
      !palpate::c::isRefused(palpate::faultOfContact(wanted), error, error_size))
    {
      return new palpate_contact{ palpate::ServoStep(
        *body->kernel, palpate::WorkspaceMapping(), maximum_force, wanted) };
    }
  }
  catch (const std::exception& failure)
  {
    palpate::c::report(
      std::string("cannot make the contact: ") + failure.what(), error, error_size);
  }
  return nullptr;
}

void palpate_contact_free(palpate_contact* contact)
{
  delete contact;
}

void palpate_step(
  palpate_contact* contact, const double position[3], double time, palpate_tick* tick)
{
  palpate::DeviceSample sample;
  sample.position = Eigen::Map<const Eigen::Vector3d>(position);
  sample.valid = true;
  palpate::c::copy(contact->servo.step(sample, time), tick);
}

void palpate_step_pose(palpate_contact* contact, const double position[3], const double axis[3],
  double time, palpate_tick* tick)
{
  const Eigen::Map<const Eigen::Vector3d> along(axis);
  palpate::DeviceSample sample;
  sample.position = Eigen::Map<const Eigen::Vector3d>(position);
  sample.orientation = palpate::orientationAlong(along);
  sample.valid = along.allFinite();
  palpate::c::copy(contact->servo.step(sample, time), tick);
}

void palpate_foresee(const palpate_contact* contact)
{
  contact->servo.foresee();
}

void palpate_reset(palpate_contact* contact)
{
  contact->servo.reset();
}

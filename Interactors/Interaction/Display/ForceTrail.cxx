// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ForceTrail.h"

#include "Interaction/Display/DashedLine.h"

#include "vtkActor.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTubeFilter.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double TrailRadius = 0.5;       // mm
constexpr double TrailDash = 1.5;         // mm
constexpr double TrailGap = 1.5;          // mm
constexpr double SmallestDistance = 0.05; // smallest distance between two contacts, mm
// Distance between the contacts that are added between two pictures, mm. On a body with a radius of
// 5 mm the line is then at most 0.03 mm below the surface.
constexpr double PassedDistance = 1.0;
} // namespace

ForceTrail::ForceTrail(vtkLookupTable* colors)
  : Tube(vtkSmartPointer<vtkTubeFilter>::New())
  , Actor(vtkSmartPointer<vtkActor>::New())
{
  this->Tube->SetRadius(TrailRadius);
  this->Tube->SetNumberOfSides(12);
  this->Tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(this->Tube->GetOutputPort());
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->LightingOff();
  this->clear();
}

ForceTrail::~ForceTrail() = default;

void ForceTrail::clear()
{
  this->Contacts.clear();
  this->Pictures = 0;
  this->IsNear = false;
  this->InAir = true;
  this->draw();
}

void ForceTrail::show(const std::vector<ShownContact>& way)
{
  this->clear();
  this->IsLive = false;
  for (const ShownContact& contact : way)
  {
    this->add(contact, true);
  }
  this->draw();
}

void ForceTrail::follow(const ShownContact& contact, std::size_t most)
{
  if (!this->IsLive)
  {
    this->clear();
    this->IsLive = true;
  }
  this->add(contact, true);
  while (this->Pictures > most || (!this->Contacts.empty() && !this->Contacts.front().isPicture))
  {
    this->Pictures -= this->Contacts.front().isPicture ? 1 : 0;
    this->Contacts.pop_front();
  }
  this->draw();
}

bool ForceTrail::isFar(const Eigen::Vector3d& point) const
{
  return this->IsLive &&
    (this->InAir || this->Contacts.empty() ||
      (point - this->Contacts.back().point).norm() > PassedDistance);
}

void ForceTrail::lift()
{
  this->InAir = true;
  this->IsNear = false;
}

void ForceTrail::add(const ShownContact& contact, bool isPicture)
{
  if (!contact.touches())
  {
    this->lift();
    return;
  }
  const Place place{ contact.tick.contact.contactPoint, contact.tick.idealForce.norm(),
    contact.isValid(), this->InAir, isPicture };
  this->InAir = false;
  if (this->IsNear)
  {
    this->Pictures -= this->Contacts.back().isPicture ? 1 : 0;
    // Distances are measured from the contact that precedes the removed one.
    this->Contacts.pop_back();
  }
  this->IsNear = !place.begins && !this->Contacts.empty() &&
    (place.point - this->Contacts.back().point).norm() < SmallestDistance;
  this->Contacts.push_back(place);
  this->Pictures += isPicture ? 1 : 0;
}

double ForceTrail::largestForce() const
{
  double largest = 0.0;
  for (const Place& place : this->Contacts)
  {
    largest = std::max(largest, place.force);
  }
  return largest;
}

std::vector<LabelObstacle> ForceTrail::segments(std::size_t most) const
{
  std::vector<LabelObstacle> pieces;
  const std::size_t count = this->Contacts.size();
  const std::size_t each = count / std::max<std::size_t>(most, 1) + 1;
  std::size_t from = 0;
  for (std::size_t i = 1; i < count; ++i)
  {
    const bool ends = i + 1 == count || this->Contacts[i + 1].begins;
    if (this->Contacts[i].begins)
    {
      from = i;
    }
    else if (i - from >= each || ends)
    {
      pieces.push_back({ this->Contacts[from].point, this->Contacts[i].point, TrailRadius });
      from = i;
    }
  }
  return pieces;
}

std::string ForceTrail::gapsInWords() const
{
  bool isBroken = false;
  for (std::size_t i = 1; i < this->Contacts.size(); ++i)
  {
    const Place& place = this->Contacts[i];
    isBroken = isBroken ||
      (place.begins && (place.point - this->Contacts[i - 1].point).norm() > 2.0 * TrailRadius);
  }
  return isBroken && this->IsDashed ? "gap: no contact,\ndashed: beyond validity"
    : isBroken                      ? "gap: no contact"
    : this->IsDashed                ? "dashed: beyond validity"
                                    : "";
}

void ForceTrail::draw()
{
  DashedLine line(TrailDash, TrailGap);
  bool begins = true;
  for (const Place& place : this->Contacts)
  {
    if (begins || place.begins)
    {
      line.moveTo(place.point, place.force);
    }
    else
    {
      line.lineTo(place.point, place.force, !place.valid);
    }
    begins = false;
  }
  this->IsDashed = line.hasGaps();
  this->Tube->SetInputData(line.take("Force"));
}
} // namespace palpate

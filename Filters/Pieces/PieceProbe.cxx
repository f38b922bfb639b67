// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/PieceProbe.h"

#include "Response/BodyConversion.h"
#include "Response/Bodies/SoundBody.h"
#include "Contact/ContactBody.h"
#include "Pieces/GatheredBody.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
// Margins, in units of the length of the longest edge. FacetRings is the sum of one edge from a
// triangle to its nearest corner, three edges that a contact crosses between searches, and one edge
// for the ring of neighbours.
constexpr double FacetRings = 5.0;
constexpr double SmoothRings = 10.0;
constexpr double Growth = 1.5;
constexpr int MostRounds = 12; // after this number of rounds, the whole body is gathered

/// Calls visit(points, size) for each polyline of the tips.
template <class Visit>
void forLines(vtkPolyData* tips, const Visit& visit)
{
  vtkCellArray* lines = tips->GetLines();
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(line, size, points);
    visit(points, size);
  }
}

Vector3 tipAt(vtkPolyData* tips, vtkIdType id)
{
  Vector3 x;
  tips->GetPoint(id, x.data());
  return x;
}
} // namespace

PieceProbe::PieceProbe(const Ranks& ranks, const BodyPiece& piece, const std::string& name)
  : Among(ranks)
  , Piece(piece)
  , Name(name)
{
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const bool isEmpty = piece.box().isEmpty();
    this->Whole.min()[axis] = ranks.smallest(isEmpty ? Infinite : piece.box().min()[axis]);
    this->Whole.max()[axis] = ranks.largest(isEmpty ? -Infinite : piece.box().max()[axis]);
  }
  this->LongestEdge = ranks.largest(piece.longestEdge());
}

/// Returns balls that are large enough in two cases: the tip touches the nearest point, or a
/// contact that began at the nearest point is tracked.
std::vector<TipBall> PieceProbe::firstBalls(vtkPolyData* tips, double indentation) const
{
  std::vector<std::array<double, 3>> own;
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    const Vector3 x = tipAt(tips, i);
    own.push_back({ x.x(), x.y(), x.z() });
  }
  // Each rank computes the distance of every tip from its piece.
  const auto all = this->Among.gather(own);
  std::vector<double> distances;
  for (const auto& ofRank : all)
  {
    for (const std::array<double, 3>& x : ofRank)
    {
      distances.push_back(this->Piece.nearest(Vector3(x[0], x[1], x[2])));
    }
  }
  std::size_t first = 0;
  for (int rank = 0; rank < this->Among.own(); ++rank)
  {
    first += all[static_cast<std::size_t>(rank)].size();
  }
  std::vector<double> nearest(own.size(), Infinite);
  for (const std::vector<double>& ofRank : this->Among.gather(distances))
  {
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      nearest[i] = std::min(nearest[i], ofRank[first + i]);
    }
  }

  std::vector<double> radii = nearest;
  forLines(tips,
    [&](const vtkIdType* points, vtkIdType size)
    {
      for (vtkIdType i = 1; i < size; ++i)
      {
        const auto before = static_cast<std::size_t>(points[i - 1]);
        const auto now = static_cast<std::size_t>(points[i]);
        const double step = (tipAt(tips, points[i]) - tipAt(tips, points[i - 1])).norm();
        if (std::isfinite(step))
        {
          radii[now] = std::max(radii[now], nearest[before] + step);
        }
      }
    });
  std::vector<TipBall> balls;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    balls.push_back(
      { { own[i][0], own[i][1], own[i][2] }, radii[i] + 4.0 * std::abs(indentation) });
  }
  return balls;
}

std::string PieceProbe::touch(const PressedTips& pressed, std::vector<PieceTouch>& touched)
{
  const bool isSmooth = pressed.settings.surface == ContactSurface::Smooth;
  const double margin = this->LongestEdge * (isSmooth ? SmoothRings : FacetRings);
  std::vector<TipBall> balls = this->firstBalls(pressed.tips, pressed.indentation);
  for (int round = 0;; ++round)
  {
    std::vector<double> needed;
    const std::string fault = this->touchPart(balls, margin, pressed, needed, touched);
    if (!fault.empty())
    {
      return fault;
    }
    bool grown = false;
    for (std::size_t i = 0; i < balls.size(); ++i)
    {
      if (needed[i] > balls[i].radius)
      {
        balls[i].radius = round < MostRounds ? Growth * needed[i] : Infinite;
        grown = true;
      }
    }
    if (!this->Among.any(grown))
    {
      return {};
    }
  }
}

std::string PieceProbe::touchPart(const std::vector<TipBall>& balls, double margin,
  const PressedTips& pressed, std::vector<double>& needed, std::vector<PieceTouch>& touched)
{
  std::vector<TipBall> finite;
  std::copy_if(balls.begin(), balls.end(), std::back_inserter(finite),
    [](const TipBall& ball)
    { return std::isfinite(ball.centre[0] + ball.centre[1] + ball.centre[2]); });
  const auto wanted = this->Among.gather(finite);
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (int rank = 0; rank < this->Among.count(); ++rank)
  {
    const std::vector<TipBall>& around = wanted[static_cast<std::size_t>(rank)];
    if (around.empty())
    {
      continue;
    }
    const auto part = this->Piece.cut(around, margin, this->Whole, this->Name);
    auto received = this->Among.send(part, rank);
    if (rank == this->Among.own())
    {
      parts = std::move(received);
    }
  }

  needed.assign(balls.size(), 0.0);
  touched.assign(balls.size(), PieceTouch{});
  std::string fault;
  if (!balls.empty())
  {
    const GatheredBody gathered(parts, this->Name);
    if (gathered.body()->GetNumberOfPolys() == 0)
    {
      for (PieceTouch& each : touched) // no tip is finite, or the body has no triangle
      {
        each.contact.state = ContactState::Invalid;
      }
    }
    else if (const auto body = makeContactBody(gathered.body(), this->Name, fault))
    {
      this->Defects = describeDefects(body->surface.defects());
      pressed.press(*body,
        [&touched](vtkIdType tip, const Contact& contact, const Vector3& at) {
          touched[static_cast<std::size_t>(tip)] = { at, contact };
        });
      needed = neededRadii(*body, pressed.tips, touched);
      for (PieceTouch& each : touched)
      {
        if (each.contact.triangle >= 0)
        {
          const GatheredBody::Origin& from =
            gathered.origin(static_cast<std::size_t>(each.contact.triangle));
          each.rank = from.rank;
          each.contact.triangle = static_cast<std::int32_t>(from.cell);
        }
      }
    }
  }
  return this->Among.firstFault(fault);
}

std::vector<double> PieceProbe::neededRadii(
  const ContactBody& body, vtkPolyData* tips, const std::vector<PieceTouch>& touched)
{
  std::vector<double> needed(touched.size(), 0.0);
  for (std::size_t i = 0; i < touched.size(); ++i)
  {
    const Vector3& at = touched[i].at;
    if (!at.allFinite())
    {
      continue;
    }
    const SurfacePoint nearest = body.tree.closest(at);
    const double distance =
      nearest.triangle < 0 ? Infinite : std::sqrt(nearest.projection.squaredDistance);
    needed[i] = (at - tipAt(tips, static_cast<vtkIdType>(i))).norm() + distance;
  }
  forLines(tips,
    [&](const vtkIdType* points, vtkIdType size)
    {
      double held = 0.0; // largest distance between the tracked contact and the preceding tip
      for (vtkIdType i = 0; i < size; ++i)
      {
        const auto now = static_cast<std::size_t>(points[i]);
        const PieceTouch& tip = touched[now];
        if (!tip.at.allFinite())
        {
          held = 0.0;
          continue;
        }
        double reach = 0.0;
        if (held > 0.0)
        {
          reach = held + (tip.at - touched[static_cast<std::size_t>(points[i - 1])].at).norm();
          needed[now] = std::max(needed[now], reach + (tip.at - tipAt(tips, points[i])).norm());
        }
        const Contact& contact = tip.contact;
        held = 0.0;
        if (contact.triangle >= 0)
        {
          held = std::max(contact.deflection, (tip.at - contact.contactPoint).norm());
        }
        else if (contact.state != ContactState::None)
        {
          held = std::max(reach, needed[now]);
        }
      }
    });
  return needed;
}
} // namespace palpate

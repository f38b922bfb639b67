// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_SceneSupply_h
#define palpate_endurance_SceneSupply_h

#include "TickFacts.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace palpate
{
struct ContactBody;
}

namespace palpate::endurance
{
/// One scene, for the model of the checker and for the session.
struct SuppliedScene
{
  FeltScene felt;
  vtkSmartPointer<vtkPolyData> body;                  ///< with the responses of the tool
  std::shared_ptr<const palpate::ContactBody> kernel; ///< made from `body`; null after an error
  std::string error;
};

/// The bodies that are supplied.
enum class Supplied
{
  All,
  Elastic, ///< the bodies that do not relax
  Relaxing ///< the body that relaxes
};

/// Several bodies at about the same place under several tools, with and without friction. The
/// responses come from vtkToolContactResponse, the kernel from the session's own conversion. Both
/// are made again for each scene.
class SceneSupply
{
public:
  explicit SceneSupply(unsigned seed, Supplied bodies = Supplied::All);

  /// Returns a scene that differs from the previous scene in body or tool.
  SuppliedScene make();

  const Vector3& centre() const { return this->Centre; }
  static constexpr double Radius = 50.0; ///< radius of all bodies to within 1.5 mm, mm
  static constexpr const char* ResponseName = "Response";

private:
  std::size_t draw(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Random);
  }

  Vector3 Centre;
  std::vector<std::shared_ptr<const RoundBody>> Bodies;
  std::vector<vtkSmartPointer<vtkPolyData>> Shapes;
  std::vector<ToolLaw> Tools;
  std::mt19937 Random;
  std::size_t From; ///< index of the first body that is supplied
  std::size_t Count;
  std::size_t Last = 0;
};
} // namespace palpate::endurance

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactControls_h
#define ContactControls_h

#include "Interaction/Panel/PanelScale.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

class vtkContactScene;
class vtkContactSetup;
class vtkHapticSession;
class vtkInteractorStyleHaptic;
class vtkLiveCharts;

namespace palpate
{
/// A number that may be changed during contact.
struct ControlQuantity
{
  std::string name;
  PanelScale scale;
  std::string (*write)(double); ///< with its unit
  std::function<double()> read;
  std::function<void(double)> change;
  bool setsForces = false;                               ///< whether forces change with it
  std::function<bool()> isOffered = [] { return true; }; ///< now
};

/// An action, or a switch.
struct ControlButton
{
  std::function<std::string()> label;
  std::function<void()> press;
  std::function<bool()> isOn = [] { return false; };
};

/// A heading; a quantity; or buttons side by side.
using ControlRow = std::variant<std::string, ControlQuantity, std::vector<ControlButton>>;

/// The content of a contact's panel: its rows, their present values, and the effect of changes. The
/// look is up to the panel.
class ContactControls
{
public:
  /// `toolShown` is called when another tool is chosen.
  ContactControls(vtkContactSetup* setup, vtkInteractorStyleHaptic* style, vtkLiveCharts* charts,
    std::function<void(int)> toolShown);
  ~ContactControls();
  ContactControls(const ContactControls&) = delete;
  ContactControls& operator=(const ContactControls&) = delete;

  /// The rows that setup and charts allow; valid as long as this object.
  std::vector<ControlRow> rows();

  /// Requests the responses for changed settings, and passes those that are ready to session and
  /// scene; returns whether there were any.
  bool update();
  /// Chooses new scales of force if forces have become much larger or smaller.
  void fitScales();

  void chooseTool(int tool);
  bool compares() const { return this->Compares; }
  void setCompares(bool compares);
  bool showsCharts() const { return this->ShowsCharts; }
  void setShowsCharts(bool shown);
  void toggleTiming();

  /// What is being computed, or what went wrong.
  std::string status() const;

private:
  vtkHapticSession* session() const;
  vtkContactScene* scene() const;
  void addContact(std::vector<ControlRow>& rows);
  void addRelaxation(std::vector<ControlRow>& rows);
  void addView(std::vector<ControlRow>& rows);
  void addSession(std::vector<ControlRow>& rows);

  vtkSmartPointer<vtkContactSetup> Setup;
  vtkSmartPointer<vtkInteractorStyleHaptic> Style;
  vtkSmartPointer<vtkLiveCharts> Charts; ///< may be null
  std::function<void(int)> ToolShown;
  bool Compares = false;
  bool ShowsCharts = true;
  double ShownForce; ///< to which the scales of force were fitted, N
};
} // namespace palpate

#endif

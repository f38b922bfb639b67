// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactControls_h
#define ContactControls_h

#include "Interaction/Panel/PanelScale.h"

#include "vtkSmartPointer.h"

#include <chrono>
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
/// A quantity that the user can change during contact.
struct ControlQuantity
{
  std::string name;
  PanelScale scale;
  std::string (*write)(double); ///< returns a value as text with its unit
  std::function<double()> read;
  std::function<void(double)> change;
  bool setsForces = false; ///< whether a change of the quantity changes the forces
  std::function<bool()> isOffered = [] { return true; }; ///< whether the row is shown
};

/// A button, which triggers an action or is a switch that is on or off.
struct ControlButton
{
  std::function<std::string()> label;
  std::function<void()> press;
  std::function<bool()> isOn = [] { return false; };
  std::function<bool()> isOffered = [] { return true; };
};

/// The row with the status text.
struct ControlStatus
{
};

/// A row of the panel: a heading, a quantity, buttons side by side, or the status.
using ControlRow =
  std::variant<std::string, ControlQuantity, std::vector<ControlButton>, ControlStatus>;

/// The content of the panel: its rows, their present values, and the effects of changes.
/// vtkContactPanel draws it.
class ContactControls
{
public:
  /// `toolShown` is called with the index of the tool when another tool is chosen.
  ContactControls(vtkContactSetup* setup, vtkInteractorStyleHaptic* style, vtkLiveCharts* charts,
    std::function<void(int)> toolShown);
  ~ContactControls();
  ContactControls(const ContactControls&) = delete;
  ContactControls& operator=(const ContactControls&) = delete;

  /// Returns the rows for the quantities and actions that the setup and the charts allow. The rows
  /// must not be used after the destruction of this object.
  std::vector<ControlRow> rows();

  /// Requests new responses if the settings have changed. Passes finished responses to the session
  /// and the scene. Returns whether responses have been passed.
  bool update();
  /// Chooses new force scales if the forces have become much larger or smaller than before.
  void fitScales();

  void chooseTool(int tool);
  bool compares() const { return this->Compares; }
  void setCompares(bool compares);
  bool showsCharts() const { return this->ShowsCharts; }
  void setShowsCharts(bool shown);
  void toggleTiming();

  /// Returns a text about the work in progress, or the error.
  std::string status() const;

private:
  bool isWaiting() const;
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
  std::chrono::steady_clock::time_point BusySince = std::chrono::steady_clock::now();
  bool Waits = false; ///< whether the computation of the responses takes longer than Patience
  double ShownForce;  ///< force to which the force scales were fitted, N
};
} // namespace palpate

#endif

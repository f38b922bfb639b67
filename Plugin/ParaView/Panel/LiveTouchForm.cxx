// SPDX-License-Identifier: BSD-3-Clause
#include "LiveTouchForm.h"

#include "Contact/ResponseContract.h"
#include "Haptics/Devices/DeviceTransports.h"
#include "Haptics/Servo/ServoStep.h"
#include "Interaction/Display/MemoryText.h"
#include "Response/Curves/StoredError.h"
#include "LiveTouchSession.h"
#include "LiveTouchSource.h"
#include "pqForceBar.h"
#include "vtkHapticSession.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace palpate
{
namespace
{
template <class Widget>
Widget* named(const char* name, const char* help)
{
  auto* widget = new Widget;
  widget->setObjectName(name);
  widget->setToolTip(help);
  return widget;
}

/// Text of the error of the newest tick, such as "± 4 %"; "–" without a contact, or if the response
/// has no error array.
QString errorOf(vtkHapticSession* session)
{
  const Tick tick = session->GetNewestTick();
  vtkPolyData* body = session->GetBody();
  const Contact& contact = tick.contact;
  if (!body || contact.triangle < 0 || contact.triangle >= body->GetNumberOfPolys())
  {
    return "–";
  }
  const vtkIdType cell =
    body->GetNumberOfVerts() + body->GetNumberOfLines() + static_cast<vtkIdType>(contact.triangle);
  const std::string words =
    errorInWords(StoredError(body, session->GetResponseName())
                   .at(cell, contact.contactPoint.data(), contact.deflection));
  return words.empty() ? QString("–") : QString::fromStdString(words).trimmed();
}

QLabel* wrapped(const char* name, const char* help)
{
  QLabel* label = named<QLabel>(name, help);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QString text(const std::string& words)
{
  return QString::fromStdString(words);
}

void set(QLabel* label, const QString& words)
{
  if (label->text() != words)
  {
    label->setText(words);
  }
}
} // namespace

LiveTouchForm::LiveTouchForm(QWidget* contents)
  : body(wrapped("body", "The source that is touched: the active source."))
  , response(named<QComboBox>("response", "The response on the body that is used, and its tool."))
  , device(named<QComboBox>("device",
      "The device: simulated (it follows the handle in the view), plant (the same, but the force "
      "moves it; plant:mass=0.1,damping=1,stiffness=300), a device that was found, or a typed one: "
      "hid:PATH, bridge:unix:/PATH, bridge:udp:PORT, replay:FILE."))
  , find(named<QToolButton>("find", "Search again for devices that are plugged in."))
  , depth(named<QDoubleSpinBox>("depth",
      "Depth to which the simulated device presses, mm. 0: half of the range of the response."))
  , snap(named<QCheckBox>("snap",
      "The simulated tip goes to the point of the surface nearest to the handle and presses there "
      "to the depth. Off: the tip is where the handle is."))
  , start(named<QPushButton>("start", "Start or end the servo loop."))
  , state(wrapped("state", "State of the contact."))
  , remark(wrapped(
      "remark", "The fault, or the reason why the applied force differs from the ideal force."))
  , bar(named<pqForceBar>("bar",
      "The force that the device applies; outline: the ideal force; red: the largest force that "
      "may reach the hand."))
  , force(named<QLabel>("force", "The force that the device applies, N."))
  , limit(named<QLabel>("limit", "The largest force of the device, N."))
  , error(named<QLabel>("error", "Estimated error of the ideal force, from the response."))
  , memory(wrapped("memory",
      "For a body that relaxes: the part of the ideal force that fades while the tool rests."))
  , deflection(named<QLabel>("deflection", "Depth of the tip in the undeformed body, mm."))
  , servo(named<QLabel>("servo", "Ticks of the servo loop, and the number of missed ticks."))
  , grant(wrapped("grant",
      "Scheduling that the system permits the servo thread, and the reason if it is not the best."))
{
  this->device->setEditable(true);
  this->device->lineEdit()->setObjectName("text");
  this->device->setInsertPolicy(QComboBox::NoInsert);
  this->device->addItems({ "simulated", "plant" });
  this->device->setMinimumContentsLength(12);
  this->device->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->response->setMinimumContentsLength(12);
  this->response->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->find->setText("Find");
  this->depth->setDecimals(3);
  this->depth->setRange(0.0, 1000.0);
  this->depth->setSingleStep(0.1);
  this->depth->setSpecialValueText("half of the range");
  this->snap->setText("snap to the surface");
  this->snap->setChecked(true);
  this->force->setMinimumWidth(this->force->fontMetrics().horizontalAdvance("00.000 N"));

  auto* choice = new QHBoxLayout;
  choice->addWidget(this->device, 1);
  choice->addWidget(this->find);
  auto* felt = new QHBoxLayout;
  felt->addWidget(this->bar, 1);
  felt->addWidget(this->force);
  auto* rows = new QFormLayout(contents);
  rows->addRow("Body", this->body);
  rows->addRow("Response", this->response);
  rows->addRow("Device", choice);
  rows->addRow("Depth (mm)", this->depth);
  rows->addRow("", this->snap);
  rows->addRow(this->start);
  rows->addRow("State", this->state);
  rows->addRow("", this->remark);
  rows->addRow("Force", felt);
  rows->addRow("Error", this->error);
  rows->addRow("Force that relaxes", this->memory);
  rows->addRow("Largest force", this->limit);
  rows->addRow("Deflection", this->deflection);
  rows->addRow("Servo rate", this->servo);
  rows->addRow("Real-time priority", this->grant);
}

void LiveTouchForm::listDevices()
{
  const QString typed = this->device->currentText();
  const PluggedDevices found = pluggedDevices();
  this->device->clear();
  this->device->addItems({ "simulated", "plant" });
  for (const PluggedDevice& one : found.devices)
  {
    const std::string name = one.name.empty() ? one.address : one.name;
    this->device->addItem(
      text(name + (one.obstacle.empty() ? "" : " (" + one.obstacle + ")")), text(one.address));
  }
  this->device->setEditText(typed);
  this->device->lineEdit()->setToolTip(text(found.text));
}

QString LiveTouchForm::chosenDevice() const
{
  const QString typed = this->device->currentText().trimmed();
  const int item = this->device->findText(typed);
  const QVariant address = item >= 0 ? this->device->itemData(item) : QVariant();
  return address.isValid() ? address.toString() : typed;
}

void LiveTouchForm::showSource(const LiveTouchSource& source, const QString& name)
{
  set(this->body, source.obstacle.isEmpty() ? name : source.obstacle);
  // The choice is kept while the body is the same.
  const QString before = source.body == this->shown ? this->chosenResponse() : QString();
  this->shown = source.body;
  const bool wasBlocked = this->response->blockSignals(true);
  this->response->clear();
  for (const StoredResponse& one : source.responses)
  {
    const std::string tool = one.tool.empty() ? "unknown tool" : one.tool;
    this->response->addItem(text(one.name + ": " + tool), text(one.name));
  }
  this->response->setCurrentIndex(std::max(0, this->response->findData(before)));
  this->response->blockSignals(wasBlocked);
}

QString LiveTouchForm::chosenResponse() const
{
  return this->response->currentData().toString();
}

void LiveTouchForm::showTouch(LiveTouchSession& touch, double rate)
{
  vtkHapticSession* session = touch.session();
  double ideal[3];
  double applied[3];
  session->GetIdealForce(ideal);
  session->GetForce(applied);
  const bool isLost = session->GetState() == vtkHapticSession::DeviceLost;
  const double most = session->GetMaximumForce();
  set(this->state,
    isLost ? text("device lost: " + session->GetDevice()->GetStatus())
           : QString(palpate::contactInWords(session->GetContactState())));
  QStringList remarks;
  for (const std::string& words :
    { touch.error(), session->GetSafetyText(), session->GetReplayText(), touch.warning() })
  {
    if (!words.empty())
    {
      remarks << text(words);
    }
  }
  if (touch.isPreparing())
  {
    remarks << "the new body is being prepared";
  }
  set(this->remark, remarks.join("; "));
  this->bar->setScale(1.2 * std::min(most, touch.peakForce()), most);
  this->bar->setForce(vtkMath::Norm(applied), vtkMath::Norm(ideal));
  set(this->force, QString::asprintf("%#.3g N", vtkMath::Norm(applied)));
  set(this->error, errorOf(session));
  const Contact contact = session->GetNewestTick().contact;
  const std::string told = memoryInWords(contact.normalForce, contact.memory);
  set(this->memory, told.empty() ? QString("–") : text(told));
  set(this->limit, QString("%1 N").arg(most, 0, 'g', 3));
  set(this->deflection, QString("%1 mm").arg(session->GetDeflection(), 0, 'f', 3));
  set(this->servo,
    QString("%1 Hz, %2 missed")
      .arg(rate > 0.0 ? QString::number(rate, 'f', 0) : QString("…"))
      .arg(static_cast<qlonglong>(session->GetRecorder()->GetNumberOfMissedTicks())));
  set(this->grant, text(session->GetRecorder()->GetRealTimeGrant()));
  this->start->setText("Stop");
  this->start->setEnabled(true);
}

void LiveTouchForm::showRest(const LiveTouchSession& touch, bool canStart, const QString& fault)
{
  const bool isPreparing = touch.state() == LiveTouchSession::State::Preparing;
  set(this->state, isPreparing ? "preparing body and device …" : "stopped");
  set(this->remark, fault);
  this->bar->setForce(0.0, 0.0);
  for (QLabel* label : { this->force, this->error, this->memory, this->limit, this->deflection,
         this->servo, this->grant })
  {
    set(label, "–");
  }
  this->start->setText(isPreparing ? "Cancel" : "Start");
  this->start->setEnabled(isPreparing || canStart);
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqForceBar_h
#define pqForceBar_h

#include <QWidget>

/**
 * A widget that shows a force (N) as a bar. The applied force is a filled bar. The ideal force is
 * an outline if it differs, and the largest force of the device is a red mark. The bar ends at the
 * full scale; a mark beyond the full scale is not drawn.
 */
class pqForceBar : public QWidget
{
  Q_OBJECT
  Q_PROPERTY(double force READ force)
  Q_PROPERTY(double limit READ limit)

public:
  explicit pqForceBar(QWidget* parent = nullptr);

  double force() const { return this->Applied; }
  double limit() const { return this->Limit; }
  /// Sets the force (N, > 0) at the end of the bar and the force at the mark.
  void setScale(double fullScale, double limit);
  void setForce(double applied, double ideal);

  QSize sizeHint() const override { return { 160, 18 }; }
  QSize minimumSizeHint() const override { return { 60, 14 }; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  double FullScale = 1.0;
  double Limit = 0.0;
  double Applied = 0.0;
  double Ideal = 0.0;
};

#endif

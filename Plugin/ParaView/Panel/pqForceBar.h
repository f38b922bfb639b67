// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqForceBar_h
#define pqForceBar_h

#include <QWidget>

/**
 * A force as a bar, N. The applied force is drawn solid. The ideal force, if it differs, is drawn
 * as an outline, and the largest force of the device as a red mark. The bar ends at the full scale;
 * a mark beyond the scale is not drawn.
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
  /// Sets the length of the bar and the position of the mark; N, > 0.
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

// Makes tests/sensor/data/pushbroom_projection.csv: a pushbroom on an orbit, located on the ground
// by Orekit Rugged (https://www.orekit.org/rugged), which shares no code with Nadir. Directly: the
// place that a pixel of a line sees, at some height above the WGS84 ellipsoid. Inversely: line and
// pixel of that place, left out where Rugged's two ways differ by more than 5e-4 pixel (its inverse
// location, a single step from the line found, feels where the turning changes). What Rugged is
// given, a table of poses and a line of sight for each pixel, is computed here; lens distortion is
// undone by bisection, not by Newton's method.
//
//   mvn dependency:copy-dependencies (org.orekit:rugged:3.0, Apache License 2.0) into lib/, then
//   java -cp 'lib/*' tools/RuggedCases.java > tests/sensor/data/pushbroom_projection.csv
//
// The frame that the earth's axes are aligned with takes the place of the turning earth: the track
// given to Rugged is the one over the ground.

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.hipparchus.geometry.euclidean.threed.Rotation;
import org.hipparchus.geometry.euclidean.threed.Vector3D;
import org.orekit.bodies.GeodeticPoint;
import org.orekit.bodies.OneAxisEllipsoid;
import org.orekit.frames.FramesFactory;
import org.orekit.rugged.api.AlgorithmId;
import org.orekit.rugged.api.InertialFrameId;
import org.orekit.rugged.api.Rugged;
import org.orekit.rugged.api.RuggedBuilder;
import org.orekit.rugged.linesensor.LineSensor;
import org.orekit.rugged.linesensor.LinearLineDatation;
import org.orekit.rugged.linesensor.SensorPixel;
import org.orekit.rugged.los.LOSBuilder;
import org.orekit.time.AbsoluteDate;
import org.orekit.time.TimeScalesFactory;
import org.orekit.utils.AngularDerivativesFilter;
import org.orekit.utils.CartesianDerivativesFilter;
import org.orekit.utils.TimeStampedAngularCoordinates;
import org.orekit.utils.TimeStampedPVCoordinates;

class RuggedCases {
  static final double SEMI_MAJOR = 6378137.0, FLATTENING = 1.0 / 298.257223563;
  static final double EARTH_RATE = 7.292115e-5, GM = 3.986004418e14;
  static final double FIRST_S = -4.0, LINE_PERIOD_S = 4.236e-3;
  static final int SAMPLES = 1200, LINES = 2000;
  static final double FOCAL_M = 0.886, PITCH_M = 36e-6;

  record Sensor(String name, double offsetX, double offsetY, double k1, double p1, double p2,
      double[][] modules) {}  // module: first, samples, offset x, offset y, rotation

  static final AbsoluteDate EPOCH =
      new AbsoluteDate(2024, 6, 1, 12, 0, 0.0, TimeScalesFactory.getTAI());

  static Vector3D position(double t) {
    final double radius = SEMI_MAJOR + 705e3, rate = Math.sqrt(GM / Math.pow(radius, 3));
    final double angle = 0.7 + rate * t, tilt = Math.toRadians(98.2);
    final Vector3D inertial = new Vector3D(radius * Math.cos(angle),
        radius * Math.sin(angle) * Math.cos(tilt), radius * Math.sin(angle) * Math.sin(tilt));
    final double turn = -1.1 - EARTH_RATE * t;
    return new Vector3D(inertial.getX() * Math.cos(turn) - inertial.getY() * Math.sin(turn),
        inertial.getX() * Math.sin(turn) + inertial.getY() * Math.cos(turn), inertial.getZ());
  }

  // Camera axes over the ground: nearly nadir, rolled by five degrees, with a slow wobble.
  static Vector3D[] axes(double t) {
    final Vector3D p = position(t);
    final Vector3D velocity = position(t + 0.5).subtract(position(t - 0.5));
    final double e2 = FLATTENING * (2.0 - FLATTENING);
    final Vector3D up = new Vector3D(p.getX(), p.getY(), p.getZ() / (1.0 - e2)).normalize();
    Vector3D z = up.negate();
    Vector3D y = velocity.subtract(new Vector3D(velocity.dotProduct(up), up)).normalize();
    Vector3D x = Vector3D.crossProduct(y, z);
    final double roll = 0.09 + 2e-4 * Math.sin(0.4 * t), pitch = 1e-4 * Math.cos(0.3 * t);
    final Vector3D x1 = new Vector3D(Math.cos(roll), x, Math.sin(roll), z);
    z = new Vector3D(-Math.sin(roll), x, Math.cos(roll), z);
    x = x1;
    final Vector3D y1 = new Vector3D(Math.cos(pitch), y, Math.sin(pitch), z);
    z = new Vector3D(-Math.sin(pitch), y, Math.cos(pitch), z);
    return new Vector3D[] {x, y1, z};
  }

  static double[] bend(Sensor s, double x, double y) {
    final double r2 = x * x + y * y, radial = 1.0 + s.k1() * r2;
    return new double[] {x * radial + 2.0 * s.p1() * x * y + s.p2() * (r2 + 2.0 * x * x),
        y * radial + s.p1() * (r2 + 2.0 * y * y) + 2.0 * s.p2() * x * y};
  }

  // One coordinate after the other by bisection, again and again: slow and hard to get wrong.
  static double[] straighten(Sensor s, double[] bent) {
    final double[] ideal = bent.clone();
    for (int round = 0; round < 60; ++round) {
      for (int i = 0; i < 2; ++i) {
        double low = bent[i] - 0.01, high = bent[i] + 0.01;
        for (int k = 0; k < 60; ++k) {
          ideal[i] = 0.5 * (low + high);
          if (bend(s, ideal[0], ideal[1])[i] > bent[i]) high = ideal[i]; else low = ideal[i];
        }
      }
    }
    return ideal;
  }

  static Vector3D sight(Sensor s, int pixel) {
    double x = s.offsetX(), y = s.offsetY(), along = (pixel + 0.5 - 0.5 * SAMPLES) * PITCH_M;
    double rotation = 0.0;
    for (double[] m : s.modules()) {
      if (pixel < m[0] || pixel >= m[0] + m[1]) continue;
      final double middle = (m[0] + 0.5 * m[1] - 0.5 * SAMPLES) * PITCH_M;
      x += m[2] + middle;
      y += m[3];
      along -= middle;
      rotation = m[4];
    }
    x += along * Math.cos(rotation);
    y += along * Math.sin(rotation);
    final double[] ideal = straighten(s, new double[] {x / FOCAL_M, y / FOCAL_M});
    return new Vector3D(ideal[0], ideal[1], 1.0).normalize();
  }

  static final List<TimeStampedPVCoordinates> places = new ArrayList<>();
  static final List<TimeStampedAngularCoordinates> turns = new ArrayList<>();

  static void tabulate() {
    for (int i = 0; i <= 40; ++i) {
      final double t = i - 20.0;
      places.add(new TimeStampedPVCoordinates(EPOCH.shiftedBy(t), position(t), Vector3D.ZERO));
      print("position,%.3f,%s%n", t, text(position(t)));
    }
    // Close together: Rugged's way between two attitudes is not quite the even one (0.02 microradian
    // off it halfway over 0.25 s; it shrinks with the square).
    for (int i = 0; i <= 216; ++i) {
      final double t = 0.05 * i - 5.25;
      final Vector3D[] a = axes(t);
      turns.add(new TimeStampedAngularCoordinates(EPOCH.shiftedBy(t),
          new Rotation(a[0], a[1], Vector3D.PLUS_I, Vector3D.PLUS_J), Vector3D.ZERO,
          Vector3D.ZERO));
      print("axes,%.3f,%s,%s,%s%n", t, text(a[0]), text(a[1]), text(a[2]));
    }
  }

  static Rugged rugged(List<LineSensor> sensors, double height) {
    final RuggedBuilder builder = new RuggedBuilder();
    builder.setAlgorithm(AlgorithmId.CONSTANT_ELEVATION_OVER_ELLIPSOID);
    builder.setConstantElevation(height);
    builder.setEllipsoid(new OneAxisEllipsoid(SEMI_MAJOR, FLATTENING, FramesFactory.getEME2000()));
    builder.setTimeSpan(EPOCH.shiftedBy(-5.0), EPOCH.shiftedBy(5.0), 2e-4, 5.0);
    builder.setTrajectory(InertialFrameId.EME2000, places, 8, CartesianDerivativesFilter.USE_P,
        turns, 2, AngularDerivativesFilter.USE_R);
    builder.setLightTimeCorrection(false);
    builder.setAberrationOfLightCorrection(false);
    for (LineSensor sensor : sensors) builder.addLineSensor(sensor);
    return builder.build();
  }

  static void print(String format, Object... what) {
    System.out.print(String.format(Locale.ROOT, format, what));
  }

  static String text(Vector3D v) {
    return String.format(Locale.ROOT, "%.17g,%.17g,%.17g", v.getX(), v.getY(), v.getZ());
  }

  public static void main(String[] arguments) {
    final List<Sensor> all = List.of(
        new Sensor("plain", 0.0, 0.0, 0.0, 0.0, 0.0, new double[0][]),
        new Sensor("offset", 40.0 * PITCH_M, 150.0 * PITCH_M, -0.8, 2e-3, -1e-3, new double[0][]),
        new Sensor("modules", 0.0, -60.0 * PITCH_M, 0.3, 0.0, 0.0,
            new double[][] {{0, 400, 5e-6, 20 * PITCH_M, 2e-4}, {400, 500, -8e-6, -20 * PITCH_M,
                -3e-4}, {900, 300, 2e-5, 20.5 * PITCH_M, 1e-4}}));
    print("# tools/RuggedCases.java with Orekit Rugged 3.0, Orekit 11.2. ECEF, m; s%n");
    print("# camera,first_line_s,line_period_s,samples,lines,focal_m,pitch_m%n");
    print("# position,time_s,x,y,z (8-point polynomial between); axes,time_s,x(3),y(3),z(3): the%n");
    print("# camera's, turning evenly between%n");
    print("# sensor,name,offset_x_m,offset_y_m,k1,p1,p2; module,of,first,samples,x,y,rotation%n");
    print("# direct|inverse,sensor,sample,line,x,y,z: (0.5, 0.5) is the first pixel's centre%n");
    print("camera,%.17g,%.17g,%d,%d,%.17g,%.17g%n", FIRST_S, LINE_PERIOD_S, SAMPLES, LINES, FOCAL_M,
        PITCH_M);
    final List<LineSensor> sensors = new ArrayList<>();
    for (Sensor s : all) {
      print("sensor,%s,%.17g,%.17g,%.17g,%.17g,%.17g%n", s.name(), s.offsetX(), s.offsetY(), s.k1(),
          s.p1(), s.p2());
      for (double[] m : s.modules()) {
        print("module,%s,%d,%d,%.17g,%.17g,%.17g%n", s.name(), (int) m[0], (int) m[1], m[2], m[3],
            m[4]);
      }
      final List<Vector3D> sights = new ArrayList<>();
      for (int i = 0; i < SAMPLES; ++i) sights.add(sight(s, i));
      sensors.add(new LineSensor(s.name(), new LinearLineDatation(EPOCH.shiftedBy(FIRST_S), 0.0,
          1.0 / LINE_PERIOD_S), Vector3D.ZERO, new LOSBuilder(sights).build()));
    }
    tabulate();
    final OneAxisEllipsoid earth =
        new OneAxisEllipsoid(SEMI_MAJOR, FLATTENING, FramesFactory.getEME2000());
    final Random random = new Random(7);
    int left_out = 0;
    for (double height : new double[] {0.0, 700.0, 4500.0}) {
      final Rugged rugged = rugged(sensors, height);
      for (Sensor s : all) {
        for (int i = 0; i < 30; ++i) {
          final double line = random.nextDouble() * (LINES - 1);
          final int pixel = random.nextInt(SAMPLES);
          final GeodeticPoint place = rugged.directLocation(s.name(), line)[pixel];
          print("direct,%s,%.1f,%.17g,%s%n", s.name(), pixel + 0.5, line + 0.5,
              text(earth.transform(place)));
          if (s.modules().length > 0) continue;  // its inverse takes sensors for nearly plane
          final SensorPixel found = rugged.inverseLocation(s.name(), place, -50, LINES + 50);
          if (Math.hypot(found.getLineNumber() - line, found.getPixelNumber() - pixel) > 5e-4) {
            ++left_out;
            continue;
          }
          print("inverse,%s,%.17g,%.17g,%s%n", s.name(), found.getPixelNumber() + 0.5,
              found.getLineNumber() + 0.5, text(earth.transform(place)));
        }
      }
    }
    print("# left out: %d%n", left_out);
  }
}

package org.phrenic.anatomy.cage;

import org.phrenic.engine.kinematics.HelicalBody;

/** Poses and twists of the bodies of a rib cage at a time, computed once for each time. */
public final class RibCagePose {

    /** How far the rib cage is inspired at a time. */
    @FunctionalInterface
    public interface RibDrive {
        /**
         * @param time s
         * @param amplitudeAndRate where to write the amplitude s (0 end-expiration, 1 full inspiration) and ds/dt (1/s)
         */
        void at(double time, double[] amplitudeAndRate);

        /**
         * Factors on the rotation of groups of ribs.
         *
         * @param gains where to write it
         * @return false if all factors are 1; then nothing is written
         */
        default boolean gains(double time, RibGains gains) {
            return false;
        }
    }

    private final RibCage cage;
    private final RibDrive drive;
    private final double[] amplitudeAndRate = new double[2];
    private final double[][] pose;
    private final double[][] twist;
    private final RibGains ribGains;
    private HelicalBody[] motions;
    private double bucket = 1;
    private double time = Double.NaN;

    public RibCagePose(RibCage cage, RibDrive drive) {
        this.cage = cage;
        this.drive = drive;
        ribGains = new RibGains(cage);
        motions = cage.motions(1);
        int n = cage.bodies().size();
        pose = new double[n][HelicalBody.POSE_LENGTH];
        twist = new double[n][HelicalBody.TWIST_LENGTH];
        for (double[] p : pose) {
            p[0] = 1;
            p[5] = 1;
            p[10] = 1;
        }
    }

    /** Moves all bodies to a time. */
    public void update(double now) {
        if (now == time) {
            return;
        }
        time = now;
        drive.at(now, amplitudeAndRate);
        boolean unlike = drive.gains(now, ribGains);
        double wanted = unlike ? ribGains.bucket() : 1;
        if (wanted != bucket) {
            bucket = wanted;
            motions = cage.motions(bucket);
        }
        for (int i = 0; i < pose.length; i++) {
            HelicalBody body = motions[i];
            if (body != null) {
                double s = unlike ? ribGains.factorOf(i) * amplitudeAndRate[0] : amplitudeAndRate[0];
                double rate = unlike
                        ? ribGains.factorOf(i) * amplitudeAndRate[1] + ribGains.factorRateOf(i) * amplitudeAndRate[0]
                        : amplitudeAndRate[1];
                body.pose(s, pose[i]);
                body.twist(rate, twist[i]);
            }
        }
    }

    public RibCage cage() {
        return cage;
    }

    /** Amplitude of the last update. */
    public double amplitude() {
        return amplitudeAndRate[0];
    }

    /** Rows of [R | t] of a body as last updated; read only. */
    public double[] pose(int body) {
        return pose[body];
    }

    /** Twist of a body as last updated; read only. */
    double[] twist(int body) {
        return twist[body];
    }
}

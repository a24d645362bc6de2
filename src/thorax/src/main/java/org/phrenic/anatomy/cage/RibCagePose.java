package org.phrenic.anatomy.cage;

import org.phrenic.engine.kinematics.HelicalBody;

/** Poses and twists of the bodies of a rib cage at a time; cached until the time changes. */
public final class RibCagePose {

    /** Amplitude of the rib cage as a function of time. */
    @FunctionalInterface
    public interface RibDrive {
        /**
         * @param time s
         * @param amplitudeAndRate receives the amplitude s (0 end-expiration, 1 full inspiration) and ds/dt (1/s)
         */
        void at(double time, double[] amplitudeAndRate);

        /**
         * Factors on the rotation of groups of ribs.
         *
         * @param gains receives the factors
         * @return false if all factors are 1; then {@code gains} is not written
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

    /** A copy for another thread, which takes over later poses by {@link #copyFrom}. */
    public RibCagePose copy() {
        RibCagePose twin = new RibCagePose(cage, drive);
        twin.copyFrom(this);
        return twin;
    }

    /** Takes over the poses of the same rib cage, and their time. */
    public void copyFrom(RibCagePose other) {
        time = other.time;
        System.arraycopy(other.amplitudeAndRate, 0, amplitudeAndRate, 0, amplitudeAndRate.length);
        for (int i = 0; i < pose.length; i++) {
            System.arraycopy(other.pose[i], 0, pose[i], 0, pose[i].length);
            System.arraycopy(other.twist[i], 0, twist[i], 0, twist[i].length);
        }
    }

    /** Updates all bodies to a time. */
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

    /** Lets the next update compute the bodies anew, after a change of what drives them at the time of the last. */
    public void invalidate() {
        time = Double.NaN;
    }

    public RibCage cage() {
        return cage;
    }

    /** Amplitude at the last update. */
    public double amplitude() {
        return amplitudeAndRate[0];
    }

    /** Rows of [R | t] of a body at the last update. The array is shared and must not be modified. */
    public double[] pose(int body) {
        return pose[body];
    }

    /** Twist of a body at the last update. The array is shared and must not be modified. */
    double[] twist(int body) {
        return twist[body];
    }
}

package org.phrenic.access.attempt;

/** How the tip of a needle moves along it: at a constant speed to a depth, where it rests. */
final class TipMotion {
    private double speed;
    private double goal;

    /** Moves the tip from a depth to another one, mm, at a speed, mm/s; false if it is there. */
    boolean start(double fromMm, double toMm, double mmPerS) {
        goal = toMm;
        speed = goal == fromMm ? 0 : mmPerS;
        return isMoving();
    }

    void stop() {
        speed = 0;
    }

    boolean isMoving() {
        return speed != 0;
    }

    /** The depth that a moving tip reaches in some time, s; it stops at the depth that it moves to. */
    double reach(double depthMm, double elapsedS) {
        double next = depthMm + Math.signum(goal - depthMm) * speed * elapsedS;
        boolean arrives = (next - goal) * (depthMm - goal) <= 0;
        if (arrives) {
            stop();
        }
        return arrives ? goal : next;
    }

    /** The depth so many mm on from the one that the tip moves to, if it moves in that direction, else from its own. */
    double further(double depthMm, double mm) {
        boolean goesOn = isMoving() && (goal - depthMm) * mm >= 0;
        return (goesOn ? goal : depthMm) + mm;
    }
}

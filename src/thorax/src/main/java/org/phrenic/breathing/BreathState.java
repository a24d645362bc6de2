package org.phrenic.breathing;

/**
 * Drive of the thorax at one time: activation, pressures, rib rotation and their rates. All values are 0 at
 * end-expiration, except phase and breath count. Mutable, so that a time step allocates nothing.
 */
public final class BreathState {
    /** Activation of the diaphragm's muscle fibres: 0 relaxed, 1 full inspiration. */
    public double activation;

    /** Time derivative of the activation, 1/s. */
    public double activationRate;

    /** Transdiaphragmatic pressure as a fraction of the maximum voluntary one, 0 to 1. */
    public double pressure;

    /** Pressure of the abdominal muscles (cough) as a fraction of the maximum, 0 to 1. */
    public double abdominalPressure;

    /** Rib rotation as a fraction of the full rotation: 0 end-expiration, 1 full inspiration. */
    public double ribTurn;

    /** Time derivative of the rib rotation, 1/s; gives prescribed ribs exact velocities. */
    public double ribTurnRate;

    /** Phase within the breath, at least 0 and below 1. */
    public double phase;

    /** Zero-based index of the breath. */
    public int breath;

    /** Respiratory phase. */
    public RespiratoryPhase respiratoryPhase = RespiratoryPhase.PAUSE;

    /**
     * Sets breath and phase at a time, for breaths of equal duration; the start of the first breath for earlier times.
     */
    public void setPlace(double timeS, double periodS) {
        double breaths = Math.max(0, timeS / periodS);
        breath = (int) breaths;
        phase = breaths - breath;
    }

    /** Sets all values to rest at end-expiration; the breath count does not change. */
    public void setAtRest(RespiratoryPhase why) {
        activation = 0;
        activationRate = 0;
        pressure = 0;
        abdominalPressure = 0;
        ribTurn = 0;
        ribTurnRate = 0;
        respiratoryPhase = why;
    }
}

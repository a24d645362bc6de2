package org.phrenic.breathing;

/**
 * The drive of the thorax at one time: activation, pressures, rotation of the ribs and their rates. Mutable, so that a
 * step writes into it and allocates nothing; all numbers are 0 at end-expiration, but for those that count.
 */
public final class BreathState {
    /** Drive of the diaphragm's fibres, 0 relaxed, 1 what a full inspiration takes. */
    public double activation;

    /** Its derivative, 1/s. */
    public double activationRate;

    /** Transdiaphragmatic pressure of the effort, as a share (0 to 1) of the greatest voluntary one. */
    public double pressure;

    /** Pressure of the abdominal muscles (cough), as a share (0 to 1) of the greatest. */
    public double abdominalPressure;

    /** Share of the ribs' full turn, 0 end-expiration, 1 full inspiration: the amplitude of a helical body. */
    public double ribTurn;

    /** Its derivative, 1/s: with it prescribed ribs have exact velocities. */
    public double ribTurnRate;

    /** Place in the breath, from 0 to below 1. */
    public double phase;

    /** Breaths begun before this one. */
    public int breath;

    /** What the breath is doing. */
    public RespiratoryPhase respiratoryPhase = RespiratoryPhase.PAUSE;

    /** Breath and place in it at a time of breaths that all last as long; before the first, its beginning. */
    public void setPlace(double timeS, double periodS) {
        double breaths = Math.max(0, timeS / periodS);
        breath = (int) breaths;
        phase = breaths - breath;
    }

    /** Rest at end-expiration; the count of breaths stays. */
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

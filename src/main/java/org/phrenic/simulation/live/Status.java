package org.phrenic.simulation.live;

public record Status(long step, double timeS, double dtS, int substeps, double stepsPerS, double realtimeFactor, boolean playing, String limitSentence, String phaseLabel) {}

package org.phrenic.simulation;

public record Overlay(Kind kind, int[] nodePairs, float[] segments) {
    public enum Kind {SPRINGS, RIGID_LINKS, ATTACHMENTS, FIBRES, ACTION_LINES, HELICAL_AXES}
}

package org.phrenic.simulation.observe;

/**
 * Lines and points drawn over the surfaces that show elements of the model. The arrays are shared; readers must not
 * modify them.
 *
 * @param kind type of element
 * @param nodePairs pairs a, b of indices into {@link Frame#nodes()}, one line each; a point where a = b
 * @param segments static lines: x, y, z of both ends, LPS, mm
 */
public record Overlay(Kind kind, int[] nodePairs, float[] segments) {
    /** Type of model element. */
    public enum Kind {
        /** Springs between nodes. */
        SPRINGS,
        /** Links of constant length across the tendon. */
        RIGID_LINKS,
        /** Nodes attached to bone, rigidly or by a spring. */
        ATTACHMENTS,
        /** Edges of the muscle that run along its fibres. */
        FIBRES,
        /** Action lines of the muscle force in the paper's model. */
        ACTION_LINES,
        /** Helical axes of ribs and sternum. */
        HELICAL_AXES
    }
}

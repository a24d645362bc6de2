package org.phrenic.simulation.observe;

/**
 * Something drawn over the surfaces to show what the model is made of. Never copied: readers write to neither array.
 *
 * @param kind what it shows
 * @param nodePairs pairs a, b of nodes of {@link Frame#nodes()}, a line each; a point where a = b
 * @param segments lines that stay where they are: x, y, z of both ends, LPS, mm
 */
public record Overlay(Kind kind, int[] nodePairs, float[] segments) {
    /** What an overlay shows. */
    public enum Kind {
        /** Springs between nodes. */
        SPRINGS,
        /** Links of constant length across the tendon. */
        RIGID_LINKS,
        /** Nodes that bone holds, directly or by a spring. */
        ATTACHMENTS,
        /** Edges of the muscle that run along its fibres. */
        FIBRES,
        /** The paper's lines of muscle force. */
        ACTION_LINES,
        /** Axes about which ribs and sternum turn. */
        HELICAL_AXES
    }
}

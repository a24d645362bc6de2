package org.phrenic.model.assembly;

import org.phrenic.engine.force.Attachments;

/** Stiffnesses of attachments, at assembly and as tuned. Tuning preserves the force of each attachment at rest. */
public final class TunableAttachments {
    private final Attachments springs;
    private final int[] nodes;
    private final int firstLungNode;
    private final double[] assembled;
    private final double[] stretch;
    private final double assembledFactor;
    private final double[] stiffness;
    private final double[] constant;

    /**
     * @param positions of all nodes at rest, caller's order, mm
     * @param firstLungNode number of the first lung node
     */
    public TunableAttachments(Attachments springs, double[] positions, int firstLungNode) {
        this.springs = springs;
        this.firstLungNode = firstLungNode;
        nodes = springs.callerNodes();
        assembled = springs.stiffnesses();
        assembledFactor = springs.stiffnessFactor();
        stretch = springs.anchorsAt(0);
        for (int i = 0; i < stretch.length; i++) {
            stretch[i] -= positions[3 * nodes[i / 3] + i % 3];
        }
        stiffness = assembled.clone();
        constant = new double[stretch.length];
    }

    /**
     * Scales the stiffnesses.
     *
     * @param asAssembled whether all parameters equal those at assembly
     * @param muscle factor at all nodes except those of the lungs
     * @param lung factor at lung nodes
     * @param factor common factor
     */
    public void tune(boolean asAssembled, double muscle, double lung, double factor) {
        for (int i = 0; i < nodes.length; i++) {
            double f = asAssembled ? 1 : nodes[i] >= firstLungNode ? lung : muscle;
            stiffness[i] = f * assembled[i];
            for (int c = 3 * i; c < 3 * i + 3; c++) {
                constant[c] = asAssembled ? 0 : (assembledFactor * assembled[i] - factor * stiffness[i]) * stretch[c];
            }
        }
        springs.setStiffnessFactor(factor);
        springs.setCoefficients(stiffness, constant);
    }
}

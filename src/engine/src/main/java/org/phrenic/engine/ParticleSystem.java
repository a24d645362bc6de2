package org.phrenic.engine;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * A system of point masses (nodes): their state, force fields, constraints, and the nodes with prescribed motion.
 *
 * <p>State is stored in flat arrays: node i (internal order) has its position at {@code positions()[3i..3i+2]}. The
 * arrays are exposed for speed. Only integrators, constraints and code that restores a state may write to them.
 */
public final class ParticleSystem {
    private final NodeLayout layout;
    private final Workers workers;
    private final double[] x;
    private final double[] v;
    private final NodeInertia masses;
    private final ForceSet fields = new ForceSet();
    private final ConstraintSet constraints;
    private final PrescribedNodes prescribed = new PrescribedNodes();
    private SelectiveMass selectiveMass;

    /**
     * @param layout order and blocks of the nodes
     * @param positions in the caller's order, mm
     * @param mass one a node in the caller's order, kg; all positive
     * @param workers threads for parallel work
     * @throws IllegalArgumentException if lengths differ, a mass is not positive and finite, or a position is not
     *     finite
     */
    public ParticleSystem(NodeLayout layout, double[] positions, double[] mass, Workers workers) {
        int n = layout.nodeCount();
        if (positions.length != 3 * n || mass.length != n) {
            throw new IllegalArgumentException("found " + positions.length + " coordinates and " + mass.length
                    + " masses, expected " + 3 * n + " and " + n);
        }
        this.layout = layout;
        this.workers = workers;
        this.x = layout.toInternal(positions);
        this.v = new double[3 * n];
        this.masses = new NodeInertia(layout, mass);
        this.constraints = new ConstraintSet(n);
        for (int i = 0; i < n; i++) {
            for (int axis = 0; axis < 3; axis++) {
                if (!Double.isFinite(x[3 * i + axis])) {
                    throw new IllegalArgumentException("position of node " + layout.caller(i) + ": found "
                            + x[3 * i + axis] + ", expected a finite number of mm");
                }
            }
        }
    }

    public NodeLayout layout() {
        return layout;
    }

    public Workers workers() {
        return workers;
    }

    public int nodeCount() {
        return layout.nodeCount();
    }

    /** Positions in internal order, mm. */
    public double[] positions() {
        return x;
    }

    /** Velocities in internal order, mm/s. */
    public double[] velocities() {
        return v;
    }

    /** Mass of each node in internal order, kg. */
    public double[] masses() {
        return masses.mass;
    }

    /** 1/mass of each node, 0 for prescribed nodes; internal order, 1/kg. */
    public double[] inverseMasses() {
        return masses.inverse;
    }

    /** Viscous damping γ of each node (force -γ v), internal order, N s/m. */
    public double[] viscosities() {
        return masses.viscosity;
    }

    /**
     * Sets the viscous damping of all nodes to one value, N s/m.
     *
     * @throws IllegalArgumentException if the value is negative or not finite
     */
    public void setViscosity(double gamma) {
        masses.setViscosity(gamma);
    }

    /**
     * Sets the viscous damping of each node in proportion to its mass: γ = rate m, rate in 1/s.
     *
     * @throws IllegalArgumentException if the rate is negative or not finite
     */
    public void setViscosityPerMass(double rate) {
        masses.setViscosityPerMass(rate);
    }

    /** Adds and enables a force field; one that was added before is refused. */
    public void add(ForceField field) {
        fields.add(field);
    }

    /** Adds and enables a constraint that was not added before. Constraints are projected in the order of adding. */
    public void add(Constraint constraint) {
        constraints.add(constraint);
    }

    /** Enables or disables a field; one that was never added is refused. A disabled field costs nothing. */
    public void setEnabled(ForceField field, boolean on) {
        fields.setEnabled(field, on);
    }

    /** Enables or disables a constraint; one that was never added is refused. A disabled constraint costs nothing. */
    public void setEnabled(Constraint constraint, boolean on) {
        constraints.setEnabled(constraint, on);
    }

    /** Whether a constraint is enabled. */
    public boolean isEnabled(Constraint constraint) {
        return constraints.active().contains(constraint);
    }

    /**
     * Discards the cached values of all fields and constraints. Call it after state, parameters or time were changed
     * from outside.
     */
    public void invalidate() {
        fields.invalidate();
        constraints.invalidate();
        prescribed.invalidate();
    }

    /**
     * Saves what fields, enabled or not, and prescribed motion keep from earlier times and cannot compute from the
     * state; allocates nothing.
     */
    public void saveHistory() {
        fields.saveHistory();
        prescribed.saveMotion();
    }

    /** Restores what {@link #saveHistory} saved last. Call {@link #invalidate} after it. */
    public void restoreHistory() {
        fields.restoreHistory();
        prescribed.restoreMotion();
    }

    /**
     * Changes the mass of a node. Its viscosity stays: call {@link #setViscosityPerMass} after it where the two go
     * together.
     *
     * @param internalNode internal number
     * @param kg more than 0
     * @throws IllegalArgumentException if the mass is not positive and finite; nothing has changed then
     */
    public void setMass(int internalNode, double kg) {
        masses.set(internalNode, kg);
        if (selectiveMass != null) {
            selectiveMass.invalidate();
        }
    }

    /**
     * Makes the translation of a group of free nodes lighter ({@link SelectiveMass}) in integrators created later.
     *
     * @param callerNodes the group, in the caller's numbering, each once, at least one
     * @param lightness factor, at least 1
     */
    public void setSelectiveMass(int[] callerNodes, double lightness) {
        selectiveMass = new SelectiveMass(internal(callerNodes), lightness, masses.mass);
    }

    /** The group of nodes whose translation is lighter, if there is one. */
    public Optional<SelectiveMass> selectiveMass() {
        return Optional.ofNullable(selectiveMass);
    }

    /** The enabled fields, in the order they were added. */
    public List<ForceField> fields() {
        return fields.active();
    }

    /** The enabled constraints, in the order they were added. */
    public List<Constraint> constraints() {
        return constraints.active();
    }

    /** Whether any enabled field depends on velocity. */
    public boolean dependsOnVelocity() {
        return fields.dependsOnVelocity();
    }

    /**
     * Sets the nodes with prescribed motion. Replaces any earlier choice, also that of {@link #fix}.
     *
     * @param callerNodes in the caller's numbering, each once
     * @param motion their positions and velocities in the same order
     * @throws IllegalArgumentException if the numbers of nodes and points differ; the earlier choice holds then
     */
    public void prescribe(int[] callerNodes, PrescribedMotion motion) {
        int[] earlier = prescribed.nodes();
        prescribed.prescribe(internal(callerNodes), motion);
        masses.release(earlier);
        masses.hold(prescribed.nodes());
    }

    private int[] internal(int[] callerNodes) {
        return Arrays.stream(callerNodes).map(layout::internal).toArray();
    }

    /**
     * Fixes nodes (caller's numbering) at their current positions. As {@link #prescribe}, it lets go all other nodes.
     */
    public void fix(int... callerNodes) {
        double[] here = new double[3 * callerNodes.length];
        for (int i = 0; i < callerNodes.length; i++) {
            System.arraycopy(x, 3 * layout.internal(callerNodes[i]), here, 3 * i, 3);
        }
        prescribe(callerNodes, PrescribedMotion.stationary(here));
    }

    /**
     * Sets the prescribed nodes to their positions and velocities at a time, in the given arrays. Stationary nodes are
     * set once.
     */
    public void applyPrescribed(double time, double[] position, double[] velocity) {
        prescribed.apply(time, position, velocity, position == x && velocity == v);
    }

    /**
     * Computes the force on each node at a state and time, without the nodes' own viscous damping.
     *
     * @param time s
     * @param position mm; prescribed nodes must be at their positions for this time
     * @param velocity mm/s
     * @param force receives the forces, mN
     */
    public void forces(double time, double[] position, double[] velocity, double[] force) {
        evaluation(position, velocity, force, null).at(time);
    }

    /**
     * The forces on all nodes as a function of time, for repeated evaluation on the same arrays.
     *
     * @param position mm
     * @param velocity mm/s
     * @param force receives the forces, mN
     * @param after runs for each block when its forces are complete; null for none. Forces of other blocks may still be
     *     incomplete. It may write to this block's forces but not to positions. It may write to this block's velocities
     *     only if no field is {@link #dependsOnVelocity}
     */
    public ForceEvaluation evaluation(double[] position, double[] velocity, double[] force, Workers.Task after) {
        return new ForceEvaluation(this, fields, position, velocity, force, after, null);
    }

    /**
     * As {@link #evaluation}, for explicit integrators: the forces are those that give the acceleration when divided by
     * the node masses, see {@link SelectiveMass}.
     */
    public ForceEvaluation inertialEvaluation(
            double[] position, double[] velocity, double[] force, Workers.Task after) {
        return new ForceEvaluation(this, fields, position, velocity, force, after, selectiveMass);
    }

    /** Adds K u of the enabled fields for the nodes of one block; see {@link ForceField#addStiffness}. */
    public void addStiffness(double[] position, double[] u, double[] out, int block) {
        fields.addStiffness(position, u, out, block);
    }

    /** Adds the row sums of the enabled fields at the current positions; see {@link ForceField#addRowSums}. */
    public void addRowSums(double[] stiffness, double[] damping) {
        fields.addRowSums(x, stiffness, damping);
    }

    /**
     * Sets the number of Gauss-Seidel sweeps over the constraints after each step. Each sweep roughly halves the
     * remaining error of coupled constraints. Constraints that share no node with another are satisfied after the
     * first.
     *
     * @throws IllegalArgumentException if it is not positive
     */
    public void setProjectionSweeps(int sweeps) {
        constraints.setSweeps(sweeps);
    }

    /**
     * Sets the simulated time between two evaluations of prescribed motion, for all fields and constraints added so
     * far, s.
     */
    public void setRefreshInterval(double seconds) {
        fields.setRefreshInterval(seconds);
        constraints.setRefreshInterval(seconds);
    }

    /** Projects all constraints at the end of a step of length h that ends at {@code time}. */
    public void project(double time, double h) {
        constraints.project(this, time, h);
    }

    /** Removes velocity components that violate the constraints; see {@link Constraint#projectVelocities}. */
    public void projectVelocities() {
        constraints.projectVelocities(this);
    }

    /** Whether the system has contact constraints, enabled or not. */
    public boolean hasContacts() {
        return constraints.hasContacts();
    }

    /** Describes an enabled constraint that the last step could not satisfy; null if all hold. */
    public String violation() {
        return constraints.violation();
    }

    /** Kinetic energy, µJ. */
    public double kineticEnergy() {
        double[] mass = masses.mass;
        double sum = 0;
        for (int i = 0; i < mass.length; i++) {
            double vx = v[3 * i];
            double vy = v[3 * i + 1];
            double vz = v[3 * i + 2];
            sum += 0.5 * mass[i] * (vx * vx + vy * vy + vz * vz);
        }
        return sum - selectiveMass().map(group -> group.energyRelief(v)).orElse(0.0);
    }

    /** Potential energy of the enabled fields, µJ. */
    public double potentialEnergy() {
        return fields.potentialEnergy(x);
    }

    /** Writes the position of a node (caller's numbering) to {@code out}. */
    public void position(int callerNode, double[] out) {
        System.arraycopy(x, 3 * layout.internal(callerNode), out, 0, 3);
    }
}

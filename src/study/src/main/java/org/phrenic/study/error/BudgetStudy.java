package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * Measures the parts of the error budget that a table lacks: errors of the defaults in time and in space, their
 * distance from equilibrium, the order of convergence, and the distance from an implicit solution.
 */
public final class BudgetStudy {
    /** Names of the settings of the implicit part. */
    static final String SCALED = "scaled mass";

    static final String TRUE_MASS = "true mass";

    /** Mass per area of muscle of 1,050 kg/m³ and 3 mm, kg/m². */
    private static final double MUSCLE_KG_PER_M2 = 3.15;
    /** Part of the window in which the order of convergence is measured. */
    private static final double ORDER_SHARE = 1.0 / 6;

    /** Halvings of the step of the order part. */
    private static final int HALVINGS = 3;
    /**
     * Steps of the implicit part, as parts of the scenario's own: short enough that constraints, which follow each
     * solve, do not undo most of it, and that neither is split for stability.
     */
    private static final int[] IMPLICIT_PARTS = {2, 4};

    private static final List<IntegratorKind> ORDER_SCHEMES =
            List.of(IntegratorKind.VERLET, IntegratorKind.STORMER, IntegratorKind.RK2, IntegratorKind.RK4);

    private final BudgetPlan plan;
    private final BudgetTable table;
    private final ProgressListener progress;

    /** @param table receives the rows; parts of scenes that it has are not measured again */
    public BudgetStudy(BudgetPlan plan, BudgetTable table, ProgressListener progress) {
        this.plan = plan;
        this.table = table;
        this.progress = progress;
    }

    /** A measurement that is to be made. */
    private record Job(BudgetPart part, BudgetPlan.Body body, String breath, String mesh, Work work) {}

    @FunctionalInterface
    private interface Work {
        List<BudgetRow> measure();
    }

    /** Measures what the table lacks of some parts. */
    public void run(Set<BudgetPart> parts) {
        List<Job> jobs = new ArrayList<>();
        for (BudgetPart part : EnumSet.copyOf(parts)) {
            for (BudgetPlan.Body body : plan.bodies()) {
                plan.breaths().forEach(breath -> addJobs(part, body, breath, jobs));
            }
        }
        jobs.removeIf(j -> table.has(j.part, j.body.name(), j.breath, j.mesh));
        for (int i = 0; i < jobs.size(); i++) {
            Job job = jobs.get(i);
            table.add(job.work.measure());
            String what = String.join(", ", job.part.label(), job.body.name(), job.breath, job.mesh);
            progress.done(i + 1, jobs.size(), what);
        }
    }

    private void addJobs(BudgetPart part, BudgetPlan.Body body, String breath, List<Job> jobs) {
        boolean first = body.equals(plan.bodies().get(0))
                && breath.equals(plan.breaths().get(0));
        if (part == BudgetPart.SPACE) {
            plan.sheetVertices()
                    .forEach(n -> jobs.add(
                            new Job(part, body, breath, Integer.toString(n), () -> List.of(space(body, breath, n)))));
            return;
        }
        for (BudgetPlan.Mesh mesh : plan.meshes()) {
            Work work =
                    switch (part) {
                        case TIME -> () -> time(body, breath, mesh, first);
                        case EQUILIBRIUM ->
                            () -> equilibrium(
                                    plan.scenario(body, breath, mesh), List.of(body.name(), breath, mesh.name()));
                        case ORDER -> () -> order(body, breath, mesh);
                        default -> () -> implicit(body, breath, mesh);
                    };
            boolean everywhere = part == BudgetPart.TIME || part == BudgetPart.EQUILIBRIUM;
            if (everywhere || (first && mesh.equals(plan.meshes().get(0)))) {
                jobs.add(new Job(part, body, breath, mesh.name(), work));
            }
            if (part == BudgetPart.EQUILIBRIUM) {
                plan.variants().forEach(variant -> jobs.add(variant(variant, body, breath, mesh)));
            }
        }
    }

    private Job variant(Scenario variant, BudgetPlan.Body body, String breath, BudgetPlan.Mesh mesh) {
        String name = mesh.name() + ", " + variant.name();
        Scenario scenario = plan.scenario(variant, body, breath, mesh);
        List<String> names = List.of(body.name(), breath, name);
        return new Job(BudgetPart.EQUILIBRIUM, body, breath, name, () -> equilibrium(scenario, names));
    }

    private List<BudgetRow> time(BudgetPlan.Body body, String breath, BudgetPlan.Mesh mesh, boolean all) {
        Scenario scenario = plan.scenario(body, breath, mesh);
        SolverGrid grid = all ? SolverGrid.integrators(scenario) : SolverGrid.own(scenario);
        ErrorStudy study = ErrorStudy.of(scenario, grid, plan.untilS(scenario), false, (done, total, what) -> {});
        double edgeMm;
        try (BreathRunner runs =
                new BreathRunner(scenario, SimulationRun.loadThorax(scenario), BreathRunner.SAMPLE_S)) {
            edgeMm = edgeMm(runs);
        }
        return study.points().stream()
                .map(p -> new BudgetRow(
                        BudgetPart.TIME,
                        body.name(),
                        breath,
                        mesh.name(),
                        p.settings().label(),
                        p.isDefault(),
                        edgeMm,
                        study.excursionsMm().get(p.settings()),
                        p.rmsMm(),
                        p.maxMm(),
                        study.referenceUncertainty()[0],
                        p.cpuS(),
                        study.simulatedS() / p.cpuS()))
                .toList();
    }

    private static double edgeMm(BreathRunner runs) {
        TriangleMesh sheet = runs.diaphragmAtRest();
        return BudgetRow.edgeMm(MeshMeasure.area(sheet), sheet.vertexCount());
    }

    /** The excursion on a mesh; NaN if the simulation diverges. */
    private BudgetRow space(BudgetPlan.Body body, String breath, int vertices) {
        Scenario scenario = plan.refined(body, breath, vertices);
        try (BreathRunner runs =
                new BreathRunner(scenario, SimulationRun.loadThorax(scenario), plan.untilS(scenario))) {
            double edgeMm = edgeMm(runs);
            double excursionMm = Double.NaN;
            double cpuS = Double.NaN;
            try {
                Trajectory run = runs.run(SolverSettings.of(scenario));
                excursionMm = runs.excursionMm(run);
                cpuS = run.cpuS();
            } catch (DivergenceException gone) {
                progress.note(String.join(", ", body.name(), breath, Integer.toString(vertices), gone.getMessage()));
            }
            return new BudgetRow(
                    BudgetPart.SPACE,
                    body.name(),
                    breath,
                    Integer.toString(vertices),
                    SolverSettings.of(scenario).label(),
                    false,
                    edgeMm,
                    excursionMm,
                    Double.NaN,
                    Double.NaN,
                    Double.NaN,
                    cpuS,
                    runs.durationS() / cpuS);
        }
    }

    private static List<BudgetRow> equilibrium(Scenario scenario, List<String> names) {
        try (BreathRunner runs =
                new BreathRunner(scenario, SimulationRun.loadThorax(scenario), ErrorStudy.breathS(scenario))) {
            SolverSettings settings = SolverSettings.of(scenario);
            Trajectory run = runs.run(settings);
            double excursionMm = runs.excursionMm(run);
            List<BudgetRow> rows = new ArrayList<>();
            for (EquilibriumLag lag : EquilibriumLag.of(runs, run, settings, EquilibriumLag.phases())) {
                String phase = SolverSettings.number(lag.timeS()) + " s";
                rows.add(new BudgetRow(
                        BudgetPart.EQUILIBRIUM,
                        names.get(0),
                        names.get(1),
                        names.get(2),
                        phase,
                        true,
                        Double.NaN,
                        excursionMm,
                        lag.heldRmsMm(),
                        lag.heldMaxMm(),
                        lag.heldDriftMm(),
                        run.cpuS(),
                        runs.durationS() / run.cpuS()));
                List<String> newton = new ArrayList<>(names);
                newton.add(phase + BudgetRow.NEWTON);
                rows.add(row(
                        BudgetPart.EQUILIBRIUM, newton, excursionMm, new double[] {lag.rmsMm(), lag.maxMm(), Double.NaN
                        }));
            }
            return rows;
        }
    }

    /** Row of a part that measures distances alone. */
    private static BudgetRow row(BudgetPart part, List<String> names, double excursionMm, double[] distances) {
        return new BudgetRow(
                part,
                names.get(0),
                names.get(1),
                names.get(2),
                names.get(3),
                true,
                Double.NaN,
                excursionMm,
                distances[0],
                distances[1],
                distances[2],
                Double.NaN,
                Double.NaN);
    }

    /** Distances between solutions whose steps differ by a factor of 2; rows with contact first. */
    private List<BudgetRow> order(BudgetPlan.Body body, String breath, BudgetPlan.Mesh mesh) {
        List<BudgetRow> rows = new ArrayList<>();
        for (boolean contact : new boolean[] {true, false}) {
            Scenario scenario = plan.scenario(body, breath, mesh).with("contact=" + contact);
            try (BreathRunner runs = new BreathRunner(
                    scenario, SimulationRun.loadThorax(scenario), plan.untilS(scenario) * ORDER_SHARE)) {
                for (IntegratorKind scheme : ORDER_SCHEMES) {
                    addOrder(runs, scenario, scheme, List.of(body.name(), breath, mesh.name()), rows);
                }
            }
        }
        return rows;
    }

    private static void addOrder(
            BreathRunner runs, Scenario scenario, IntegratorKind scheme, List<String> scene, List<BudgetRow> rows) {
        boolean[] sheet = runs.diaphragmNodes();
        String contact = scenario.toMap().get("contact").equals(true) ? "contact" : "no contact";
        Trajectory coarse = null;
        double step = scenario.timeStepS();
        for (int i = 0; i <= HALVINGS; i++) {
            Trajectory fine = runs.run(SolverGrid.converged(scheme, step, scenario.timeStepS()));
            if (coarse != null) {
                double[] apart = coarse.distanceFrom(fine, sheet);
                String name = String.join(", ", scheme.label(), contact, SolverSettings.number(2 * step) + " s");
                List<String> names = new ArrayList<>(scene);
                names.add(name);
                rows.add(row(
                        BudgetPart.ORDER, names, runs.excursionMm(fine), new double[] {apart[0], apart[1], Double.NaN
                        }));
            }
            coarse = fine;
            step /= 2;
        }
    }

    /**
     * Distance of the default from backward Euler, extrapolated to step 0 from two steps, with the same masses and with
     * those of muscle.
     */
    private List<BudgetRow> implicit(BudgetPlan.Body body, String breath, BudgetPlan.Mesh mesh) {
        Scenario scenario = plan.scenario(body, breath, mesh);
        List<BudgetRow> rows = new ArrayList<>();
        double untilS = plan.untilS(scenario);
        Trajectory usual;
        double excursionMm;
        boolean[] sheet;
        try (BreathRunner runs = new BreathRunner(scenario, SimulationRun.loadThorax(scenario), untilS)) {
            usual = runs.run(SolverSettings.of(scenario));
            excursionMm = runs.excursionMm(usual);
            sheet = runs.diaphragmNodes();
        }
        for (String masses : List.of(SCALED, TRUE_MASS)) {
            Scenario solved = masses.equals(SCALED)
                    ? scenario
                    : scenario.with("area_density_kg_per_m2=" + MUSCLE_KG_PER_M2, "mass_scaling_s=1e-6");
            try (BreathRunner runs = new BreathRunner(solved, SimulationRun.loadThorax(solved), untilS)) {
                Trajectory coarse = implicit(runs, scenario, IMPLICIT_PARTS[0]);
                Trajectory fine = implicit(runs, scenario, IMPLICIT_PARTS[1]);
                double[] apart = usual.distanceFrom(Trajectory.extrapolated(coarse, fine), sheet);
                double[] steps = coarse.distanceFrom(fine, sheet);
                rows.add(row(
                        BudgetPart.IMPLICIT,
                        List.of(body.name(), breath, mesh.name(), masses),
                        excursionMm,
                        new double[] {apart[0], apart[1], steps[0]}));
            }
        }
        return rows;
    }

    private static Trajectory implicit(BreathRunner runs, Scenario scenario, int parts) {
        double step = scenario.timeStepS() / parts;
        SolverSettings settings = SolverGrid.converged(IntegratorKind.BACKWARD_EULER, step, step);
        return runs.run(settings);
    }
}

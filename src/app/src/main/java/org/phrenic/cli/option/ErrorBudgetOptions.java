package org.phrenic.cli.option;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.error.BudgetPart;
import org.phrenic.study.error.BudgetPlan;
import org.phrenic.study.error.BudgetReport;
import org.phrenic.study.error.BudgetStudy;
import org.phrenic.study.error.BudgetTable;
import picocli.CommandLine.Option;

/** Options of {@code phrenic bench error --whole}: which parts of the error budget to measure on which bodies. */
public final class ErrorBudgetOptions {
    private static final List<BudgetPlan.Body> VIRTUAL_BODIES = List.of(
            new BudgetPlan.Body("virtual man", RunSettings.VIRTUAL_MAN),
            new BudgetPlan.Body("virtual woman", RunSettings.VIRTUAL_WOMAN));

    @Option(
            names = "--whole",
            description = "The whole error of the defaults: in time, in space and against equilibrium, quiet and deep."
                    + " DIR keeps what was measured (budget.csv) and of what (plan.yaml), so that an interrupted run"
                    + " goes on.")
    private boolean whole;

    @Option(
            names = "--part",
            paramLabel = "NAME,...",
            description = "With --whole: some of time, space, equilibrium, order, implicit (default all).")
    private String parts;

    @Option(
            names = "--scan",
            paramLabel = "DIR",
            description = "With --whole: a scanned body besides the virtual ones.")
    private Path scan;

    @Option(
            names = "--beside",
            paramLabel = "FILE",
            description = "With --whole: a scenario whose distance from equilibrium is measured beside the defaults'.")
    private Path beside;

    public boolean isGiven() {
        return whole;
    }

    /**
     * Measures what the folder's table lacks.
     *
     * @param resolutions names of the resolutions, comma separated
     * @param out folder of the table; null to keep it in memory
     * @return the report of all that the table has
     */
    public BudgetReport measure(String resolutions, boolean quick, Path out, ProgressListener progress) {
        List<BudgetPlan.Body> bodies = new ArrayList<>(VIRTUAL_BODIES);
        if (scan != null) {
            if (!Files.isDirectory(scan)) {
                throw new BadInputException("--scan: found no folder '" + scan + "', expected a folder of meshes");
            }
            ThoraxFolder.load(scan);
            bodies.add(new BudgetPlan.Body(FileNames.ofBody(scan), scan.toString()));
        }
        List<Resolution> meshes = OptionValues.split(resolutions).stream()
                .map(OptionValues::resolution)
                .toList();
        Set<BudgetPart> wanted = parts();
        BudgetPlan plan = quick ? BudgetPlan.quick(bodies) : BudgetPlan.full(bodies, meshes, variants(wanted));
        BudgetTable table = out == null ? new BudgetTable() : new BudgetTable(out, plan);
        new BudgetStudy(plan, table, progress).run(wanted);
        return new BudgetReport(table);
    }

    private List<Scenario> variants(Set<BudgetPart> wanted) {
        if (beside == null) {
            return List.of();
        }
        if (!wanted.contains(BudgetPart.EQUILIBRIUM)) {
            throw new BadInputException("--beside: found it without the part equilibrium, expected both");
        }
        Scenario variant = Scenario.read(beside);
        for (Setting<?> fixed : List.of(OrganSettings.MESH_VERTICES, Breathing.TRACE)) {
            if (variant.states(fixed)) {
                throw new BadInputException("--beside " + beside + ": found " + fixed.key()
                        + ", expected a scenario for each breath and mesh of the measurement");
            }
        }
        return List.of(variant);
    }

    private Set<BudgetPart> parts() {
        Set<BudgetPart> named = EnumSet.noneOf(BudgetPart.class);
        if (parts == null) {
            return EnumSet.allOf(BudgetPart.class);
        }
        for (String name : OptionValues.split(parts)) {
            named.add(BudgetPart.of(name)
                    .orElseThrow(() -> new BadInputException(
                            "--part: found '" + name + "', expected some of " + BudgetPart.labels())));
        }
        return named;
    }
}

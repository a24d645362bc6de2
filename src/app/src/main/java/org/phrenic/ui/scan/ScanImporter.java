package org.phrenic.ui.scan;

import java.awt.Window;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.FileNames;
import org.phrenic.file.UnfinishedFiles;
import org.phrenic.patient.pipeline.ImportPipeline;
import org.phrenic.patient.pipeline.ImportRequest;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.FileWrites;
import org.phrenic.ui.session.Session;

/**
 * Imports scans in the window: reads the labels, asks for the options, builds the body beside the running scene, writes
 * its thorax folder, shows a summary and opens the body. Used on the event dispatch thread.
 */
public final class ScanImporter {
    /** What the window shows of an import. */
    public interface Display {
        /** A stage and the completed share; a share of 1 ends the display. */
        void showProgress(String stage, double share);

        /** Begins a rehearsal of liver access with the present body. */
        void rehearse();

        /** Whether an attempt is under way, which another body would end. */
        boolean isAttemptUnderWay();
    }

    /** The table of labels in the thorax folder, if it was edited. */
    static final String LABELS_FILE = "labels.csv";

    private static final String KEPT_TABLE =
            LABELS_FILE + ": was in the folder and stays as it is; the body is of the proposed structures";

    private final Window owner;
    private final Session session;
    private final Display display;
    private final Consumer<Path> open;
    private final Consumer<Path> read;
    private Optional<CancellableProgress> running = Optional.empty();

    /**
     * @param open opens the thorax folder of the body
     * @param read gets each scan whose labels were read
     */
    public ScanImporter(Window owner, Session session, Display display, Consumer<Path> open, Consumer<Path> read) {
        this.owner = owner;
        this.session = session;
        this.display = display;
        this.open = open;
        this.read = read;
    }

    /** Reads the labels of a volume and asks for the options; one import runs at a time. */
    public void begin(Path file) {
        if (running.isPresent()) {
            session.refuse("An import is running; cancel it first.");
            return;
        }
        CancellableProgress progress = new CancellableProgress(display::showProgress);
        running = Optional.of(progress);
        display.showProgress("reading " + file.getFileName(), 0);
        BackgroundWorker.execute(
                () -> ScanLabels.read(file, template(RunSettings.VIRTUAL_MAN)),
                labels -> {
                    if (isRunning(progress)) {
                        running = Optional.empty();
                        display.showProgress("", 1);
                        read.accept(file);
                        ask(file, new ScanImportDialog(file, labels));
                    }
                },
                sentence -> failIfRunning(progress, sentence));
    }

    private void ask(Path file, ScanImportDialog dialog) {
        dialog.show(owner, choice -> run(file, dialog, choice));
    }

    private void failIfRunning(CancellableProgress progress, String sentence) {
        if (isRunning(progress)) {
            fail(sentence);
        }
    }

    /**
     * Cancels the running import, or the reading of a scan. Before its thorax folder is written, nothing is written.
     */
    public void cancel() {
        if (running.isPresent() && running.get().cancel()) {
            session.note("The import is cancelled; nothing is written.");
        }
        running = Optional.empty();
    }

    /** Whether a scan is read or imported. */
    public boolean isRunning() {
        return running.isPresent();
    }

    private boolean isRunning(CancellableProgress progress) {
        return running.filter(progress::equals).isPresent();
    }

    void run(Path file, ScanImportDialog dialog, ScanImportDialog.Choice choice) {
        if (running.isPresent()) {
            session.refuse("An import is running; cancel it first.");
            // Its answers are still there, for when the other import has ended.
            ask(file, dialog);
            return;
        }
        CancellableProgress progress = new CancellableProgress(display::showProgress);
        running = Optional.of(progress);
        display.showProgress("importing " + file.getFileName(), 0);
        BackgroundWorker.execute(
                () -> build(file, choice, progress, Path.of(System.getProperty("java.io.tmpdir"))),
                built -> built.filter(result -> isRunning(progress))
                        .ifPresent(result -> finish(choice.folder(), result)),
                sentence -> {
                    if (isRunning(progress)) {
                        fail(sentence);
                        // Its answers are still there, to be corrected.
                        ask(file, dialog);
                    }
                });
    }

    /**
     * The imported body, written to its folder; empty if the import was cancelled.
     *
     * @param temporary folder for a table of labels, which is written if they are edited
     */
    static Optional<ImportResult> build(
            Path file, ScanImportDialog.Choice choice, CancellableProgress progress, Path temporary)
            throws IOException {
        Path table = temporary.resolve("phrenic-labels-" + UUID.randomUUID() + ".csv");
        // The window may be closed meanwhile.
        UnfinishedFiles.add(table);
        try {
            String name = FileNames.ofBody(choice.folder());
            ImportRequest request = new ImportRequest(
                    file,
                    name,
                    choice.labels().writeIfEdited(table).map(Path::toString),
                    Optional.empty(),
                    choice.geometry(),
                    choice.template().map(body -> new ImportRequest.Completion(template(body), false)),
                    Optional.empty());
            ImportResult built = ImportPipeline.run(request, progress);
            progress.beginWriting();
            return Optional.of(write(built, choice));
        } catch (CancellationException cancelled) {
            return Optional.empty();
        } finally {
            if (Files.exists(table)) {
                Files.delete(table);
            }
            UnfinishedFiles.remove(table);
        }
    }

    /**
     * Writes the body and its labels to the folder. A table of unknown origin is its user's, and stays with a note.
     *
     * @return the result with the note
     */
    private static ImportResult write(ImportResult built, ScanImportDialog.Choice choice) {
        FileWrites writing = FileWrites.begin(choice.folder().toString());
        Path table = choice.folder().resolve(LABELS_FILE);
        try {
            ImportResult result =
                    !choice.labels().isEdited() && Files.exists(table) ? built.withNote(KEPT_TABLE) : built;
            result.write(choice.folder());
            choice.labels().writeIfEdited(table);
            return result;
        } finally {
            writing.end();
        }
    }

    private static Thorax template(String body) {
        Assignment anatomy = Assignment.read("template " + body, "anatomy", body);
        return SimulationRun.loadThorax(Scenario.defaults().with(List.of(anatomy)));
    }

    void finish(Path folder, ImportResult result) {
        running = Optional.empty();
        display.showProgress("", 1);
        boolean waits = display.isAttemptUnderWay();
        ImportSummaryDialog.show(owner, result, () -> {
            if (waits || !isPresent(folder)) {
                open.accept(folder);
            }
            display.rehearse();
        });
        if (!result.body().canBreathe()) {
            session.refuse("The body in " + folder + " cannot breathe: it takes a diaphragm and ribs.");
        } else if (waits) {
            session.note("The body is in " + folder + "; Rehearse in its summary opens it and ends this attempt.");
        } else {
            open.accept(folder);
        }
    }

    /** Whether the body in a folder is the present one, or loads. */
    private boolean isPresent(Path folder) {
        String place = folder.toAbsolutePath().normalize().toString();
        return session.scenario().get(RunSettings.ANATOMY).equals(place);
    }

    private void fail(String sentence) {
        running = Optional.empty();
        display.showProgress("", 1);
        session.refuse(sentence);
    }
}

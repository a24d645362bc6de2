package org.phrenic;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaCall;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaConstructorCall;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.awt.image.BufferedImage;
import java.io.FileOutputStream;
import java.io.FileWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** The walls inside the Maven modules, and what no compiler holds: no cycles, no screen in a headless run. */
class ArchitectureTest {
    static final JavaClasses PROGRAM = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(location -> !location.contains("-tests.jar") && !location.contains("test-classes"))
            // The module of clusters stands above the program and is built by a profile alone.
            .withImportOption(location -> !location.contains("org/phrenic/cluster/"))
            .importPackages("org.phrenic");

    /** Methods of {@link Math} whose last bit the Java machine and the processor decide. */
    private static final Set<String> ROUNDED_BY_THE_MACHINE = Set.of(
            "sin cos tan asin acos atan atan2 sinh cosh tanh exp expm1 log log10 log1p pow cbrt hypot".split(" "));

    private static final Set<String> WRITERS =
            Set.of("write", "writeString", "newOutputStream", "newBufferedWriter", "newByteChannel", "createFile");

    /** What each chapter (the packages that share the name after {@code org.phrenic}) uses, no more and no less. */
    private static final Map<String, List<String>> USES = new LinkedHashMap<>();

    static {
        declare("engine", "");
        declare("file", "");
        declare("mesh", "engine file");
        declare("document", "file");
        declare("parameter", "breathing document file");
        declare("anatomy", "document engine file mesh");
        declare("breathing", "document engine file");
        declare("model", "anatomy breathing document engine file mesh parameter");
        declare("scenario", "anatomy breathing document engine file mesh model parameter");
        declare("simulation", "anatomy breathing document engine file mesh model parameter scenario");
        declare("motion", "anatomy document engine file mesh model simulation");
        declare("patient", "anatomy document engine file mesh");
        declare("fit", "anatomy document engine file mesh model motion parameter patient scenario simulation");
        declare("access", "anatomy breathing document engine file mesh model scenario simulation");
        declare(
                "study",
                "access anatomy breathing document engine file fit"
                        + " mesh model parameter patient scenario simulation");
        declare("scene", "access anatomy breathing document file mesh scenario simulation");
        declare(
                "ui",
                "access anatomy breathing document engine file mesh model"
                        + " parameter patient scenario scene simulation");
        declare(
                "cli",
                "access anatomy breathing document engine file fit mesh model"
                        + " motion parameter patient scenario scene simulation study ui");
    }

    private static void declare(String chapter, String used) {
        USES.put(chapter, used.isEmpty() ? List.of() : List.of(used.split(" ")));
    }

    private static String within(String name) {
        return "org.phrenic." + name + "..";
    }

    /** Neither an arrow that is not allowed nor one that is allowed and not used. */
    @Test
    void eachChapterUsesWhatIsDeclared() {
        Map<String, Set<String>> found = new TreeMap<>();
        for (JavaClass from : PROGRAM) {
            Set<String> used = found.computeIfAbsent(chapterOf(from), name -> new TreeSet<>());
            from.getDirectDependenciesFromSelf().stream()
                    .map(dependency -> dependency.getTargetClass().getBaseComponentType())
                    .filter(to -> to.getPackageName().startsWith("org.phrenic"))
                    .map(ArchitectureTest::chapterOf)
                    .filter(name -> !name.equals(chapterOf(from)))
                    .forEach(used::add);
        }
        assertThat(found.keySet()).isEqualTo(USES.keySet());
        Set<String> differences = new TreeSet<>();
        USES.forEach((name, used) -> {
            found.get(name).stream()
                    .filter(other -> !used.contains(other))
                    .forEach(other -> differences.add(name + " uses " + other + ", which is not declared"));
            used.stream()
                    .filter(other -> !found.get(name).contains(other))
                    .forEach(other -> differences.add(name + " is declared to use " + other + ", but does not"));
        });
        assertThat(differences).isEmpty();
    }

    private static String chapterOf(JavaClass type) {
        return type.getPackageName().split("\\.")[2];
    }

    @Test
    void noPackagesUseEachOther() {
        check(slices().matching("org.phrenic.(**)").should().beFreeOfCycles());
    }

    @Test
    void engineKnowsNoFileAndNoScreen() {
        check(noClasses()
                .that()
                .resideInAPackage(within("engine"))
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "java.io..", "java.nio.file..", "java.awt..", "javax..", "org.yaml..", "picocli.."));
    }

    @Test
    void onlyPicturesAndWindowKnowTheScreen() {
        check(noClasses()
                .that()
                .resideOutsideOfPackages(within("scene"), within("ui"), within("cli.chart"))
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.awt..", "javax.swing..", "com.jogamp.."));
    }

    @Test
    void onlyTheCommandLinePrints() {
        check(noClasses()
                .that()
                .resideOutsideOfPackage(within("cli"))
                .should()
                .accessField(System.class, "out")
                .orShould()
                .accessField(System.class, "err")
                .orShould()
                .callMethod(Throwable.class, "printStackTrace"));
    }

    @Test
    void onlyTheCommandLineEndsTheProcessAndKnowsItsParser() {
        check(noClasses()
                .that()
                .resideOutsideOfPackage(within("cli"))
                .should()
                .callMethod(System.class, "exit", int.class)
                .orShould()
                .dependOnClassesThat()
                .resideInAPackage("picocli.."));
    }

    /** Calls of code that writes into a file that is named, and not to a stream that is given. */
    private static boolean writesFile(JavaCall<?> call) {
        JavaClass owner = call.getTargetOwner();
        List<String> taken = call.getTarget().getRawParameterTypes().stream()
                .map(JavaClass::getSimpleName)
                .toList();
        boolean isMade = call instanceof JavaConstructorCall;
        if (owner.isEquivalentTo(Files.class)) {
            // Of a stream or a file to a path; that of a path to a stream reads.
            boolean copies = call.getName().equals("copy") && taken.get(1).equals("Path");
            return WRITERS.contains(call.getName()) || copies;
        }
        if (owner.isEquivalentTo(FileChannel.class)) {
            return call.getName().equals("open");
        }
        if (owner.isEquivalentTo(ImageIO.class)) {
            return call.getName().equals("write") && taken.contains("File");
        }
        return isMade
                && (owner.isAssignableTo(FileOutputStream.class)
                        || owner.isAssignableTo(FileWriter.class)
                        || owner.isEquivalentTo(RandomAccessFile.class)
                        || (List.of("PrintStream", "PrintWriter", "Formatter").contains(owner.getSimpleName())
                                && List.of("File", "String").contains(taken.isEmpty() ? "" : taken.get(0))));
    }

    private static ArchRule onlyTheseWrite(String... journals) {
        DescribedPredicate<JavaCall<?>> writing =
                DescribedPredicate.describe("write to a file", ArchitectureTest::writesFile);
        return noClasses()
                .that()
                .resideOutsideOfPackage(within("file"))
                .and(DescribedPredicate.describe(
                        "are no journals", type -> !List.of(journals).contains(type.getSimpleName())))
                .should()
                .callCodeUnitWhere(writing);
    }

    /** Files are written beside their target and moved over it; journals alone are appended to. */
    @Test
    void onlyAtomicFilesAreWritten() {
        check(onlyTheseWrite("FitJournal", "ShapeFile", "SweepJournal"));
    }

    /** Each of its calls writes over a file. */
    static final class WritesFiles {
        void write(Path path, InputStream in) throws IOException {
            Files.createFile(path);
            Files.copy(in, path);
            Files.newByteChannel(path).close();
            FileChannel.open(path).close();
            ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "png", path.toFile());
            new RandomAccessFile(path.toFile(), "rw").close();
            new FileOutputStream(path.toFile()).close();
            new FileWriter(path.toFile(), StandardCharsets.UTF_8).close();
            new PrintStream(path.toFile(), StandardCharsets.UTF_8).close();
            new PrintWriter(path.toString(), StandardCharsets.UTF_8).close();
        }

        void read(Path path, OutputStream out) throws IOException {
            Files.copy(path, out);
            ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "png", out);
            new PrintStream(out, true, StandardCharsets.UTF_8).flush();
        }
    }

    @Test
    void everyWayToWriteOverAFileIsSeen() {
        JavaClasses calls = new ClassFileImporter().importClasses(WritesFiles.class);
        assertThat(onlyTheseWrite().evaluate(calls).getFailureReport().getDetails())
                .hasSize(10)
                .allMatch(found -> found.contains("write(java.nio.file.Path"));
    }

    /** StrictMath gives the same bits on every Java machine; what is only drawn or shown may take Math. */
    @Test
    void resultsTakeStrictMath() {
        DescribedPredicate<JavaAccess<?>> rounding = DescribedPredicate.describe(
                "a method of Math with a last bit of the machine",
                access -> access.getTargetOwner().isEquivalentTo(Math.class)
                        && ROUNDED_BY_THE_MACHINE.contains(access.getName()));
        check(noClasses()
                .that()
                .resideOutsideOfPackages(within("scene"), within("ui"), within("cli.chart"))
                .should()
                .accessTargetWhere(rounding));
    }

    @Test
    void nothingStaticChanges() {
        check(fields().that().areStatic().should().beFinal());
    }

    @Test
    void exceptionsOfAllKindsAreNamedSo() {
        check(classes().that().areAssignableTo(Throwable.class).should().haveSimpleNameEndingWith("Exception"));
    }

    private static void check(ArchRule rule) {
        rule.allowEmptyShould(true).check(PROGRAM);
    }
}

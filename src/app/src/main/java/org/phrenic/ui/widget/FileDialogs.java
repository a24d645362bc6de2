package org.phrenic.ui.widget;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;
import javax.swing.plaf.basic.BasicFileChooserUI;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.ui.session.WindowPreferences;

/** Dialogs that choose a file or folder and remember the folder it is in; empty if the dialog is cancelled. */
public final class FileDialogs {
    private FileDialogs() {}

    /** A file to write; gets the suffix of {@code proposed} where it has none. An existing file is confirmed. */
    public static Optional<Path> save(Component parent, String title, String proposed) {
        String suffix = proposed.substring(proposed.lastIndexOf('.') + 1);
        JFileChooser chooser = chooser(title, suffix);
        chooser.setSelectedFile(new File(chooser.getCurrentDirectory(), proposed));
        if (chooser.showSaveDialog(parent) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        File chosen = chooser.getSelectedFile();
        File file = chosen.getName().toLowerCase(Locale.ROOT).endsWith("." + suffix)
                ? chosen
                : new File(chosen.getParentFile(), chosen.getName() + "." + suffix);
        Optional<String> question = Optional.of("Replace " + file.getName() + ", which is there already?")
                .filter(text -> file.exists());
        return confirmed(parent, title, file, question);
    }

    public static Optional<Path> open(Component parent, String title, String... suffixes) {
        return chosen(parent, chooser(title, suffixes));
    }

    public static Optional<Path> openFileOrFolder(Component parent, String title) {
        JFileChooser chooser = chooser(title);
        chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        return chosen(parent, chooser);
    }

    /**
     * A folder to write into; one in the last folder is proposed, by this name unless it is empty.
     *
     * @param files names of files that are written, each of which is confirmed if it is there already
     */
    public static Optional<Path> folder(Component parent, String title, String proposed, List<String> files) {
        JFileChooser chooser = chooser(title);
        propose(chooser, proposed);
        if (chooser.showSaveDialog(parent) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        File folder = chooser.getSelectedFile();
        return confirmed(parent, title, folder, replaced(folder, files));
    }

    /** Asks whether files of a folder are replaced, by their names; empty if none of them is there. */
    static Optional<String> replaced(File folder, List<String> files) {
        String there =
                files.stream().filter(name -> new File(folder, name).exists()).collect(Collectors.joining(", "));
        return Optional.of("Replace " + there + " in " + folder.getName() + "?").filter(text -> !there.isEmpty());
    }

    /** Lets a chooser choose folders and shows the name of a new one, which need not exist. */
    static void propose(JFileChooser chooser, String name) {
        chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
        if (!name.isEmpty() && chooser.getUI() instanceof BasicFileChooserUI shown) {
            shown.setFileName(new File(chooser.getCurrentDirectory(), name).getPath());
        }
    }

    private static Optional<Path> chosen(Component parent, JFileChooser chooser) {
        if (chooser.showOpenDialog(parent) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        Optional<Path> path = path(chooser.getSelectedFile(), refusal(parent, chooser.getDialogTitle()));
        path.ifPresent(FileDialogs::rememberFolder);
        return path;
    }

    private static Optional<Path> confirmed(Component parent, String title, File file, Optional<String> question) {
        Optional<Path> path = path(file, refusal(parent, title));
        if (path.isEmpty()) {
            return path;
        }
        rememberFolder(path.get());
        boolean write = question.isEmpty()
                || JOptionPane.showConfirmDialog(parent, question.get(), title, JOptionPane.OK_CANCEL_OPTION)
                        == JOptionPane.OK_OPTION;
        return write ? path : Optional.empty();
    }

    /** The path of a file; empty where its name is none of this system, which the consumer gets in one sentence. */
    static Optional<Path> path(File file, Consumer<String> refuse) {
        try {
            return Optional.of(FileNames.path(file.getPath()));
        } catch (BadInputException unwritable) {
            refuse.accept(unwritable.getMessage());
            return Optional.empty();
        }
    }

    private static Consumer<String> refusal(Component parent, String title) {
        return sentence -> JOptionPane.showMessageDialog(parent, sentence, title, JOptionPane.ERROR_MESSAGE);
    }

    private static JFileChooser chooser(String title, String... suffixes) {
        JFileChooser chooser =
                new JFileChooser(WindowPreferences.ofUser().folder().toFile());
        chooser.setDialogTitle(title);
        if (suffixes.length > 0) {
            String name = String.join(", ", suffixes).toUpperCase(Locale.ROOT) + " files";
            chooser.setFileFilter(new FileNameExtensionFilter(name, suffixes));
        }
        return chooser;
    }

    private static void rememberFolder(Path file) {
        Path folder = file.toAbsolutePath().getParent();
        if (folder != null) {
            WindowPreferences.ofUser().setFolder(folder);
        }
    }
}

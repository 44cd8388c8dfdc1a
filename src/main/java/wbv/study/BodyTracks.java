package wbv.study;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import wbv.recording.Channel;
import wbv.recording.inspect.RowBlock;
import wbv.recording.inspect.UniformReader;
import wbv.task.TrackCells;
import wbv.task.TrackFile;

/** Bodies that are followed through a recording side by side, and the files that hold their tracks, row by row. */
final class BodyTracks implements Closeable {

    private final List<TrackFile> files = new ArrayList<>();
    private final List<Follower> followers = new ArrayList<>();

    /** Follows a body through a block of rows. */
    private record Follower(FollowedBody body, int input, int[] others, int output, double[] crossing, TrackCells cells)
            implements Consumer<RowBlock> {

        @Override
        public void accept(RowBlock block) {
            cells.clear();
            for (int i = 0; i < block.count(); i++) {
                double[] row = block.row(i);
                for (int k = 0; k < others.length; k++) {
                    crossing[k] = row[others[k]];
                }
                cells.add(body.accept(row[input], crossing, row[output]));
            }
        }
    }

    /** Takes a file into which the tracks go. */
    void into(TrackFile file) {
        files.add(file);
    }

    /**
     * Takes the next body.
     *
     * @param input what moves it
     * @param others the base's other motions
     */
    void follow(FollowedBody body, UniformReader reader, Channel input, List<Channel> others) {
        int[] columns = others.stream().mapToInt(other -> RowBlock.column(reader, other)).toArray();
        followers.add(new Follower(body, RowBlock.column(reader, input), columns, RowBlock.column(reader, body.channel()),
                new double[columns.length], new TrackCells()));
    }

    /** What follows the bodies, to be shown each block. */
    List<Consumer<RowBlock>> takers() {
        return List.copyOf(followers);
    }

    /** Writes what was found of the rows of a block, after all have seen it. */
    void write(RowBlock block) {
        files.parallelStream().forEach(file -> {
            for (int i = 0; i < block.count(); i++) {
                file.begin(block.row(i)[0]);
                for (Follower each : followers) {
                    file.add(each.cells, i);
                }
                file.end();
            }
        });
    }

    /** Gives the files their names. */
    void finish() throws IOException {
        for (TrackFile file : files) {
            file.finish();
        }
    }

    @Override
    public void close() throws IOException {
        for (TrackFile file : files) {
            file.close();
        }
    }
}

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>新しいプロジェクト…</translation>
    </message>
    <message>
        <source>Make a project from videos or connected cameras</source>
        <translation>動画や接続されたカメラからプロジェクトを作ります</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>デモを開く</translation>
    </message>
    <message>
        <source>Open the simulated demo scene</source>
        <translation>シミュレーションのデモシーンを開く</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>プロジェクトを別の名前で保存</translation>
    </message>
    <message>
        <source>Close project</source>
        <translation>プロジェクトを閉じる</translation>
    </message>
    <message>
        <source>Back to the start page</source>
        <translation>開始ページに戻ります</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Quit Dewpoint</source>
        <translation>Dewpoint を終了</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>最後の変更を取り消します</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Make the change that was taken back again</source>
        <translation>取り消した変更をやり直します</translation>
    </message>
    <message>
        <source>Shortcuts…</source>
        <translation>ショートカット…</translation>
    </message>
    <message>
        <source>See and change all shortcuts</source>
        <translation>すべてのショートカットを見て変更します</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>再生または一時停止</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>次のフレーム</translation>
    </message>
    <message>
        <source>Track one frame and pause</source>
        <translation>1 フレーム追跡して一時停止</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>1 回反復</translation>
    </message>
    <message>
        <source>One filter iteration on the frame shown, and pause</source>
        <translation>表示中のフレームでフィルターを 1 回反復して一時停止</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Start over with the same random numbers</source>
        <translation>同じ乱数で最初からやり直す</translation>
    </message>
    <message>
        <source>Restart with a new seed</source>
        <translation>新しいシードで最初から</translation>
    </message>
    <message>
        <source>Start over with other random numbers</source>
        <translation>別の乱数で最初からやり直す</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Show mask</source>
        <translation>マスクを表示</translation>
    </message>
    <message>
        <source>Show where the cameras see the target&apos;s color</source>
        <translation>カメラが目標の色を捉えている場所を表示</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view from above: the XY plane</source>
        <translation>上からの鳥瞰図：XY 平面</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view from the front: the XZ plane</source>
        <translation>正面からの鳥瞰図：XZ 平面</translation>
    </message>
    <message>
        <source>Search actions…</source>
        <translation>操作を検索…</translation>
    </message>
    <message>
        <source>Find any action by its name</source>
        <translation>名前で操作を探します</translation>
    </message>
    <message>
        <source>Put all views back where they were at first</source>
        <translation>すべての表示を最初の位置に戻します</translation>
    </message>
    <message>
        <source>Colors of the system</source>
        <translation>システムの配色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Light colors</source>
        <translation>ライトの配色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Dark colors</source>
        <translation>ダークの配色</translation>
    </message>
    <message>
        <source>Remove the target</source>
        <translation>ターゲットを取り除く</translation>
    </message>
    <message>
        <source>Stop following the target that is chosen</source>
        <translation>選んだターゲットの追跡をやめます</translation>
    </message>
    <message>
        <source>Learn the color</source>
        <translation>色を学習</translation>
    </message>
    <message>
        <source>Then click the target in a camera image: its color is learned</source>
        <translation>続けてカメラ画像のターゲットをクリックすると、その色を学習します</translation>
    </message>
    <message>
        <source>Add a target</source>
        <translation>ターゲットを追加</translation>
    </message>
    <message>
        <source>Follow one more thing: click it in a camera image</source>
        <translation>もう1つ追跡します。カメラ画像でクリックしてください</translation>
    </message>
    <message>
        <source>Export trajectory…</source>
        <translation>軌跡を書き出す…</translation>
    </message>
    <message>
        <source>Write the trajectory so far for another program</source>
        <translation>これまでの軌跡を他のプログラム用に書き出します</translation>
    </message>
    <message>
        <source>Save a picture of a view…</source>
        <translation>ビューの画像を保存…</translation>
    </message>
    <message>
        <source>Save a camera image, the bird&apos;s-eye view or a plot as PNG</source>
        <translation>カメラ画像、鳥瞰図、グラフを PNG で保存します</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>前のフレーム</translation>
    </message>
    <message>
        <source>Show the frame before this one as it was</source>
        <translation>ひとつ前のフレームを当時のまま表示します</translation>
    </message>
    <message>
        <source>Back to now</source>
        <translation>現在に戻る</translation>
    </message>
    <message>
        <source>Show again where the run stands</source>
        <translation>実行の現在位置を再び表示します</translation>
    </message>
    <message>
        <source>Track again from here</source>
        <translation>ここから再追跡</translation>
    </message>
    <message>
        <source>Track again from the moment shown, with the method, parameters and colors of now; pausing stops it</source>
        <translation>表示中の時点から、現在の手法・パラメータ・色で追跡し直します。一時停止で止まります</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>この時点をマーク</translation>
    </message>
    <message>
        <source>Put a named mark on the moment shown</source>
        <translation>表示中の時点に名前付きのマークを付けます</translation>
    </message>
    <message>
        <source>Remove the mark</source>
        <translation>マークを外す</translation>
    </message>
    <message>
        <source>Take the mark away from the moment shown</source>
        <translation>表示中の時点のマークを外します</translation>
    </message>
    <message>
        <source>Previous mark</source>
        <translation>前のマーク</translation>
    </message>
    <message>
        <source>Show the moment of the mark before this one</source>
        <translation>前のマークの時点を表示します</translation>
    </message>
    <message>
        <source>Next mark</source>
        <translation>次のマーク</translation>
    </message>
    <message>
        <source>Show the moment of the next mark</source>
        <translation>次のマークの時点を表示します</translation>
    </message>
    <message>
        <source>Zoom to the selected span</source>
        <translation>選択した区間を拡大</translation>
    </message>
    <message>
        <source>Let the timeline show the selected span only</source>
        <translation>タイムラインに選択区間だけを表示します</translation>
    </message>
    <message>
        <source>Show evidence</source>
        <translation>根拠を表示</translation>
    </message>
    <message>
        <source>Show how likely the cameras find each place around the target, and which places were considered</source>
        <translation>ターゲットの周囲の各位置をカメラがどれだけ確からしいと見るか、どの位置が候補になったかを表示します</translation>
    </message>
    <message>
        <source>Show best particle</source>
        <translation>最良のパーティクルを表示</translation>
    </message>
    <message>
        <source>Mark the particle of highest weight (MAP) of each target with a triangle, in all views</source>
        <translation>各ターゲットの重みが最大のパーティクル(MAP)を、すべてのビューで三角形で示します</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Plot spread</source>
        <translation>広がりを表示</translation>
    </message>
    <message>
        <source>Standard deviation of the particles along x, y and z</source>
        <translation>x、y、z 方向の粒子の標準偏差</translation>
    </message>
    <message>
        <source>Plot effective sample size</source>
        <translation>有効サンプルサイズを表示</translation>
    </message>
    <message>
        <source>How many particles the weighted ones are worth, and how many there are</source>
        <translation>重み付き粒子が何個分に相当するかと、粒子の総数</translation>
    </message>
    <message>
        <source>Plot likelihood</source>
        <translation>尤度を表示</translation>
    </message>
    <message>
        <source>What each camera says of the estimate: its log likelihood</source>
        <translation>各カメラから見た推定の対数尤度</translation>
    </message>
    <message>
        <source>Plot existence</source>
        <translation>存在確率を表示</translation>
    </message>
    <message>
        <source>Probability that the target is at the estimate, by all cameras and by each alone</source>
        <translation>推定位置にターゲットがある確率（全カメラおよび各カメラ単独）</translation>
    </message>
    <message>
        <source>Plot error</source>
        <translation>誤差を表示</translation>
    </message>
    <message>
        <source>Distance of the estimate from the truth, where it is known</source>
        <translation>真値がわかる場合の、推定と真値の距離</translation>
    </message>
    <message>
        <source>Plot time per step</source>
        <translation>1 ステップの時間を表示</translation>
    </message>
    <message>
        <source>Microseconds that each filter iteration took, per target</source>
        <translation>ターゲットごとの各フィルタ反復にかかったマイクロ秒</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>時間軸</translation>
    </message>
    <message>
        <source>Plot over seconds instead of filter iterations</source>
        <translation>フィルタ反復ではなく秒で表示</translation>
    </message>
    <message>
        <source>Whole run</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Plot the whole run again (double click does the same)</source>
        <translation>もう一度全体を表示（ダブルクリックでも可）</translation>
    </message>
    <message>
        <source>Copy plots as CSV</source>
        <translation>グラフを CSV でコピー</translation>
    </message>
    <message>
        <source>Copy the numbers of the plots shown, as a table</source>
        <translation>表示中のグラフの数値を表としてコピー</translation>
    </message>
    <message>
        <source>Save plots as picture…</source>
        <translation>グラフを画像として保存…</translation>
    </message>
    <message>
        <source>Save the plots as shown, as SVG or PNG</source>
        <translation>表示中のグラフを SVG または PNG で保存</translation>
    </message>
    <message>
        <source>Copy trajectory as CSV</source>
        <translation>軌跡を CSV でコピー</translation>
    </message>
    <message>
        <source>Copy the selected rows of the trajectory, or all</source>
        <translation>軌跡の選択行（なければ全行）をコピー</translation>
    </message>
    <message>
        <source>Calibrate by hand…</source>
        <translation>手動で校正…</translation>
    </message>
    <message>
        <source>Adjust cameras until a grid lies on the real thing in their images</source>
        <translation>画像の中で格子が実物に重なるまでカメラを調整します</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>較正をインポート…</translation>
    </message>
    <message>
        <source>Take the cameras&apos; calibration from a file of any tool</source>
        <translation>任意のツールのファイルからカメラの較正を取り込む</translation>
    </message>
    <message>
        <source>Export calibration…</source>
        <translation>較正をエクスポート…</translation>
    </message>
    <message>
        <source>Write the cameras&apos; calibration for another tool</source>
        <translation>ほかのツールのためにカメラの較正を書き出す</translation>
    </message>
    <message>
        <source>Calibrate by waving…</source>
        <translation>振って較正…</translation>
    </message>
    <message>
        <source>Refine cameras with a waved ball, or a stick with two balls</source>
        <translation>振ったボール、または2つのボールの付いた棒でカメラを精密化する</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>キャリブレーション</translation>
    </message>
    <message>
        <source>Calibrate with a board…</source>
        <translation>ボードでキャリブレーション…</translation>
    </message>
    <message>
        <source>Find lenses and places of the cameras with a printed board</source>
        <translation>印刷したボードでカメラのレンズと位置を求めます</translation>
    </message>
    <message>
        <source>Print a calibration board…</source>
        <translation>キャリブレーションボードを印刷…</translation>
    </message>
    <message>
        <source>Write the board to calibrate with as a PDF in its true size</source>
        <translation>キャリブレーション用ボードを実寸のPDFに書き出します</translation>
    </message>
    <message>
        <source>Plan the rig…</source>
        <translation>配置を計画…</translation>
    </message>
    <message>
        <source>See how well the cameras will measure, and where one more would help</source>
        <translation>カメラの測定精度と、もう1台が役立つ場所を見る</translation>
    </message>
    <message>
        <source>Show the map of expected errors</source>
        <translation>予想誤差のマップを表示</translation>
    </message>
    <message>
        <source>Show in the bird&apos;s-eye view how far off a target is expected to be at each place</source>
        <translation>各場所でターゲットがどれだけずれると予想されるかを鳥瞰図に表示</translation>
    </message>
    <message>
        <source>Add a camera to plan</source>
        <translation>計画にカメラを追加</translation>
    </message>
    <message>
        <source>Add a camera that is not there yet, to be dragged about</source>
        <translation>まだ存在しないカメラを追加してドラッグする</translation>
    </message>
    <message>
        <source>Re-solve the bumped camera</source>
        <translation>動いたカメラを解き直す</translation>
    </message>
    <message>
        <source>Calibrate the camera that was turned during the run as it stands now; all others stay</source>
        <translation>実行中に回転したカメラを現在の姿勢に校正します。他のカメラはそのままです</translation>
    </message>
    <message>
        <source>Find the best place for one more camera</source>
        <translation>もう1台のカメラの最適な場所を探す</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the place from which one more camera helps most</source>
        <translation>もう1台のカメラが最も役立つ場所を壁と天井で探す</translation>
    </message>
    <message>
        <source>Experiments…</source>
        <translation>実験…</translation>
    </message>
    <message>
        <source>Make the figures of the papers anew, with a report</source>
        <translation>論文の図を作り直し、レポートにします</translation>
    </message>
    <message>
        <source>Take a box</source>
        <translation>枠を取る</translation>
    </message>
    <message>
        <source>Export volumes of people…</source>
        <translation>人物の体積を書き出す…</translation>
    </message>
    <message>
        <source>Write places, volumes, hulls and densities on the floor of all people as tables</source>
        <translation>全人物の位置、体積、凸包、床の上の密度を表として書き出す</translation>
    </message>
    <message>
        <source>A person stands here…</source>
        <translation>ここに人がいます…</translation>
    </message>
    <message>
        <source>Say where somebody is: by a click on the person in a camera image, or on the floor in the bird&apos;s-eye view</source>
        <translation>人のいる場所を伝える：カメラ画像の中の人、または鳥瞰図の床をクリック</translation>
    </message>
    <message>
        <source>Remove this person</source>
        <translation>この人物を取り除く</translation>
    </message>
    <message>
        <source>The person chosen in the table is not there</source>
        <translation>表で選んだ人物はそこにいません</translation>
    </message>
    <message>
        <source>Show volumes of people</source>
        <translation>人物の体積を表示</translation>
    </message>
    <message>
        <source>Show the hull that holds 95 % of each person, and the density of each on the floor</source>
        <translation>各人物の 95 % を含む凸包と、床の上での密度を表示</translation>
    </message>
    <message>
        <source>Filter threads…</source>
        <translation>フィルターのスレッド数…</translation>
    </message>
    <message>
        <source>Choose how many threads share the work of the filter</source>
        <translation>フィルターの処理を分担するスレッド数を選びます</translation>
    </message>
    <message>
        <source>It is here</source>
        <translation>ここにあります</translation>
    </message>
    <message>
        <source>Drag a target in the camera images to where it is in the frame shown: tracking goes on from there</source>
        <translation>表示中のフレームで、カメラ画像のターゲットを実際の位置へドラッグします。そこから追跡を続けます</translation>
    </message>
    <message>
        <source>Remove the correction</source>
        <translation>修正を取り消す</translation>
    </message>
    <message>
        <source>Take away where you said that the selected target is in the frame shown; without a selected target, of all</source>
        <translation>表示中のフレームで選択中のターゲットに指定した位置を取り消します。選択がなければすべてのターゲットが対象です</translation>
    </message>
    <message>
        <source>Show the volume of interest</source>
        <translation>探索範囲を表示</translation>
    </message>
    <message>
        <source>Show the box in which targets are searched for, in the images and in the bird&apos;s-eye view</source>
        <translation>ターゲットを探す箱をカメラ画像と鳥瞰図に表示します</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>再追跡</translation>
    </message>
    <message>
        <source>Track all again that is of earlier settings</source>
        <translation>以前の設定による結果をすべて追跡し直します</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>遅く</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to 1/30</source>
        <translation>録画をより遅く再生します（1/30 まで）</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>速く</translation>
    </message>
    <message>
        <source>Play the recording faster, up to eight times</source>
        <translation>録画をより速く再生します（8 倍まで）</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>通常の速度</translation>
    </message>
    <message>
        <source>Play the recording as fast as it was filmed</source>
        <translation>録画を撮影時と同じ速さで再生します</translation>
    </message>
    <message>
        <source>Slowly until it converges</source>
        <translation>収束するまでゆっくり</translation>
    </message>
    <message>
        <source>Play the first iterations of a run one by one, until every target is held (five seconds at most)</source>
        <translation>すべてのターゲットが追跡中になるまで、実行の最初の反復を 1 回ずつ再生します（最長 5 秒）</translation>
    </message>
    <message>
        <source>Show magnifier</source>
        <translation>拡大鏡を表示</translation>
    </message>
    <message>
        <source>Enlarge the particles of a target in a corner of the image where they are too close together to be seen</source>
        <translation>ターゲットの粒子が密集して見えないとき、画像の隅に拡大して表示します</translation>
    </message>
    <message>
        <source>Show lines of sight</source>
        <translation>視線を表示</translation>
    </message>
    <message>
        <source>Draw a line in the bird&apos;s-eye view from each camera to the target: broken where it is hidden from the camera</source>
        <translation>鳥瞰図に各カメラからターゲットまでの線を引きます。カメラから隠れている場合は破線です</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Enlarge the camera image under the pointer, or that of the selected camera (the wheel does the same)</source>
        <translation>ポインターの下のカメラ画像、または選択中のカメラの画像を拡大します（ホイールでも可）</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Show more of the camera image under the pointer, or of that of the selected camera</source>
        <translation>ポインターの下のカメラ画像、または選択中のカメラの画像をより広く表示します</translation>
    </message>
    <message>
        <source>Fit image</source>
        <translation>画像全体を表示</translation>
    </message>
    <message>
        <source>Show all of the camera image again (double click does the same)</source>
        <translation>もう一度カメラ画像の全体を表示します（ダブルクリックでも可）</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>上面図</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>正面図</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D 表示</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view in perspective, free to orbit</source>
        <translation>透視図の鳥瞰図、自由に回転</translation>
    </message>
    <message>
        <source>Fit everything in view</source>
        <translation>すべてをビューに収める</translation>
    </message>
    <message>
        <source>Show the whole room in the bird&apos;s-eye view again (double click does the same)</source>
        <translation>もう一度鳥瞰図に部屋全体を表示します（ダブルクリックでも可）</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>レイアウトをリセット</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全画面表示</translation>
    </message>
    <message>
        <source>Let the window fill the screen, or give it its frame back</source>
        <translation>ウィンドウを画面いっぱいに広げるか、元の枠に戻します</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Plot position</source>
        <translation>位置を表示</translation>
    </message>
    <message>
        <source>Position along x, y and z with a band of two standard deviations, and the truth where it is known</source>
        <translation>x、y、z 方向の位置と標準偏差の 2 倍の帯、わかる場合は真値</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>Open the manual at the page of the view that is in use</source>
        <translation>使用中のビューのページでマニュアルを開きます</translation>
    </message>
    <message>
        <source>Quick start</source>
        <translation>クイックスタート</translation>
    </message>
    <message>
        <source>What you see in the window, and how to begin in five steps</source>
        <translation>ウィンドウに見えるものと、5 つの手順での始め方</translation>
    </message>
    <message>
        <source>Legend of the overlays</source>
        <translation>重ね描きの凡例</translation>
    </message>
    <message>
        <source>What crosses, ellipses and dots in the images mean</source>
        <translation>画像の中の十字、楕円、点の意味</translation>
    </message>
    <message>
        <source>About the methods</source>
        <translation>手法について</translation>
    </message>
    <message>
        <source>Open the reference of the tracking methods</source>
        <translation>追跡手法のリファレンスを開きます</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>問題を報告…</translation>
    </message>
    <message>
        <source>Collect what helps to find a fault, ready to be copied</source>
        <translation>不具合を見つけるのに役立つ情報を集め、コピーできるようにします</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Dewpoint について</translation>
    </message>
    <message>
        <source>Version, license, and how to cite Dewpoint</source>
        <translation>バージョン、ライセンス、Dewpoint の引用方法</translation>
    </message>
    <message>
        <source>Show images in the bird&apos;s-eye view</source>
        <translation>鳥瞰図に画像を表示</translation>
    </message>
    <message>
        <source>Show what each camera sees, in the bird&apos;s-eye view, on the pyramid it looks through</source>
        <translation>各カメラに見えているものを、鳥瞰図でその視野の角錐の上に表示します</translation>
    </message>
</context>
<context>
    <name>AssessedRegions</name>
    <message>
        <source>matches too</source>
        <translation>これも一致</translation>
    </message>
    <message>
        <source>also the target (Alt-click if not)</source>
        <translation>これもターゲット (違う場合は Alt+クリック)</translation>
    </message>
</context>
<context>
    <name>BoardText</name>
    <message>
        <source>%1: rms %2, focal length %3, %4 pictures; known to %5</source>
        <translation>%1: rms %2、焦点距離 %3、画像 %4 枚、精度 %5</translation>
    </message>
    <message>
        <source>Corners in only %1 % of its image: show the board in all of it, also tilted.</source>
        <translation>角があるのは画像の%1 %だけです。画像全体で、傾けても見せてください。</translation>
    </message>
    <message>
        <source>%1 keeps its place: it never saw the board.</source>
        <translation>%1の位置はそのままです。ボードが一度も見えませんでした。</translation>
    </message>
    <message>
        <source>%1: rms %2</source>
        <translation>%1: rms %2</translation>
    </message>
    <message>
        <source>, place ±%1, direction ±%2</source>
        <translation>、位置 ±%1、向き ±%2</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>レンズ</translation>
    </message>
    <message>
        <source>%1 keeps its lens: %2</source>
        <translation>%1のレンズはそのままです: %2</translation>
    </message>
    <message>
        <source>Places: rms %1 over %2 positions of the board</source>
        <translation>位置: ボード %2 か所で rms %1</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>its left side nearer</source>
        <translation>左側を近く</translation>
    </message>
    <message>
        <source>its right side nearer</source>
        <translation>右側を近く</translation>
    </message>
    <message>
        <source>its upper side nearer</source>
        <translation>上側を近く</translation>
    </message>
    <message>
        <source>its lower side nearer</source>
        <translation>下側を近く</translation>
    </message>
    <message>
        <source>facing the camera</source>
        <translation>カメラの正面に</translation>
    </message>
    <message>
        <source>No image yet</source>
        <translation>まだ画像がありません</translation>
    </message>
    <message>
        <source>Show it the whole board</source>
        <translation>ボード全体を見せてください</translation>
    </message>
    <message>
        <source>Move the board to: %1</source>
        <translation>ボードを動かす: %1</translation>
    </message>
    <message>
        <source>Tilt it, %1</source>
        <translation>傾ける: %1</translation>
    </message>
    <message>
        <source>Come nearer with the board</source>
        <translation>ボードを近づけてください</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>静止させてください</translation>
    </message>
    <message>
        <source>The image is soft: focus, or more light</source>
        <translation>画像がぼけています。ピントを合わせるか明るくしてください</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ 完了</translation>
    </message>
    <message>
        <source>✓ All cameras have seen enough together</source>
        <translation>✓ すべてのカメラが十分に同時に見ました</translation>
    </message>
    <message>
        <source>Show the board to %1 and %2 at once, hold it still, then elsewhere</source>
        <translation>ボードを%1と%2に同時に見せて静止させ、別の場所でも繰り返してください</translation>
    </message>
    <message>
        <source>no board in sight</source>
        <translation>ボードが見えません</translation>
    </message>
    <message>
        <source>⚠ soft, edges of %1</source>
        <translation>⚠ ぼけ、エッジ幅 %1</translation>
    </message>
    <message>
        <source>sharp, edges of %1</source>
        <translation>鮮明、エッジ幅 %1</translation>
    </message>
    <message>
        <source>%1 of at least %2 views</source>
        <translation>%1 / 少なくとも %2 ビュー</translation>
    </message>
    <message>
        <source>%1 views, known to %2 (wanted: %3)</source>
        <translation>%1 ビュー、精度 %2（目標: %3）</translation>
    </message>
    <message>
        <source>● sees the board</source>
        <translation>● ボードが見えています</translation>
    </message>
    <message>
        <source>○ does not see the board</source>
        <translation>○ ボードが見えません</translation>
    </message>
    <message>
        <source>%1 views, place known to %2</source>
        <translation>%1 ビュー、位置の精度 %2</translation>
    </message>
    <message>
        <source>%1 views with others</source>
        <translation>他と共通のビュー %1</translation>
    </message>
    <message>
        <source>The places were not found: %1</source>
        <translation>位置は求められませんでした: %1</translation>
    </message>
    <message>
        <source>How good it is cannot be said: too few places were seen by two cameras.</source>
        <translation>どれほど良いかは判定できません。2台のカメラで見えた場所が少なすぎます。</translation>
    </message>
</context>
<context>
    <name>CalibrationFiles</name>
    <message>
        <source>Calibrations (%1)</source>
        <translation>キャリブレーション (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>CalibrationText</name>
    <message>
        <source>Everything fits when %1 and %2 are exchanged: their videos are likely swapped. Exchange the two files.</source>
        <translation>%1 と %2 を入れ替えるとすべて合います。動画が逆になっているようです。2つのファイルを入れ替えてください。</translation>
    </message>
    <message>
        <source>%1 fits when its video is shifted: it likely shows everything %2 frames late. Synchronize the videos, or let time offsets be found.</source>
        <translation>%1 は動画をずらすと合います。おそらくすべてが %2 フレーム遅れています。動画を同期させるか、時間のずれを求めてください。</translation>
    </message>
    <message>
        <source>%1 fits when its video is shifted: it likely shows everything %2 frames early. Synchronize the videos, or let time offsets be found.</source>
        <translation>%1 は動画をずらすと合います。おそらくすべてが %2 フレーム早まっています。動画を同期させるか、時間のずれを求めてください。</translation>
    </message>
    <message>
        <source>%1 fits one place before %2 and another after: it was likely moved or bumped then. Calibrate with the part after it.</source>
        <translation>%1 は %2より前と後で位置が異なります。そのとき動かされたかぶつけられたようです。その後の部分で較正してください。</translation>
    </message>
    <message>
        <source>%1 fits only with flipped images: its video is likely mirrored or upside down. Set how its images are turned and mirrored.</source>
        <translation>%1 は画像を反転させたときだけ合います。動画が鏡像か上下逆のようです。画像の回転と鏡像を設定してください。</translation>
    </message>
    <message>
        <source>%1 fits with a focal length %2 times the given one: its zoom (or a crop) was likely changed. Calibrate its lens again.</source>
        <translation>%1 は焦点距離を %2 倍にすると合います。ズーム（または切り出し）が変わったようです。レンズを較正し直してください。</translation>
    </message>
    <message>
        <source>The lens data of %1 are likely for another resolution: its images are %2 times as large. Convert them, or record at the calibrated size.</source>
        <translation>%1 のレンズデータは別の解像度のもののようです。画像は %2 倍の大きさです。換算するか、較正した大きさで録画してください。</translation>
    </message>
    <message>
        <source>In this volume ±%1 (95 %)</source>
        <translation>この空間内で ±%1 (95 %)</translation>
    </message>
    <message>
        <source>, scale ±%1 %</source>
        <translation>、縮尺 ±%1 %</translation>
    </message>
    <message>
        <source>, scale unknown</source>
        <translation>、縮尺は不明</translation>
    </message>
    <message>
        <source>, up ±%1</source>
        <translation>、鉛直 ±%1</translation>
    </message>
    <message>
        <source>, up not measured</source>
        <translation>、鉛直は未測定</translation>
    </message>
    <message>
        <source>all cameras</source>
        <translation>全カメラ</translation>
    </message>
    <message>
        <source>The cameras would all look at the back of the board or floor: its points are likely mirrored. Check the direction of its axes, and that the print is not reversed.</source>
        <translation>すべてのカメラがボードまたは床の裏側を見ていることになります。点が鏡像になっているようです。軸の向きと、印刷が反転していないことを確かめてください。</translation>
    </message>
    <message>
        <source>The given length is %1 times what the cameras see: millimeters and meters are likely mixed up.</source>
        <translation>与えられた長さはカメラの見る長さの %1 倍です。ミリメートルとメートルを取り違えているようです。</translation>
    </message>
    <message>
        <source>The given length is %1 times what the cameras see: it is likely in inches (1 inch = 2.54 cm).</source>
        <translation>与えられた長さはカメラの見る長さの %1 倍です。インチのようです（1 インチ = 2.54 cm）。</translation>
    </message>
    <message>
        <source>The corners form a board with %1 in a row: the number of squares is likely wrong. Count them and correct the board.</source>
        <translation>角は1列に %1 個あるボードをなしています。マス目の数が違うようです。数えてボードを直してください。</translation>
    </message>
    <message>
        <source>The board&apos;s squares are given %1 times as large as the cameras see them: measure a row with a ruler (prints are often rescaled).</source>
        <translation>ボードのマス目はカメラの見る大きさの %1 倍とされています。定規で1列を測ってください（印刷はよく拡大縮小されます）。</translation>
    </message>
    <message>
        <source>The images fit when shifted by %1 along both axes: a program likely counts pixels from their corners. Convert the principal points.</source>
        <translation>画像は両軸に %1 ずらすと合います。ピクセルの角を原点に数えるツールがあるようです。主点を換算してください。</translation>
    </message>
</context>
<context>
    <name>CameraAgreement</name>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped, or %3 and %4.</source>
        <translation>%1 と %2、または %3 と %4 が入れ替わっているようです。</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped.</source>
        <translation>%1 と %2 が入れ替わっているようです。</translation>
    </message>
    <message>
        <source>%1 or %2 looks at least %3 away from its calibration.</source>
        <translation>%1 または %2 の向きが、キャリブレーションから少なくとも %3 ずれています。</translation>
    </message>
    <message>
        <source>%1 looks about %2 away from its calibration.</source>
        <translation>%1 の向きが、キャリブレーションから約 %2 ずれています。</translation>
    </message>
    <message>
        <source>%1 and %2 do not see the target at one position. Calibrate them again.</source>
        <translation>%1 と %2 では、ターゲットの位置が一致しません。キャリブレーションをやり直してください。</translation>
    </message>
    <message>
        <source>%1 does not agree with the other cameras. Calibrate it again.</source>
        <translation>%1 が他のカメラと一致しません。キャリブレーションをやり直してください。</translation>
    </message>
    <message>
        <source>%1 is about %2 late.</source>
        <translation>%1 は約 %2 遅れています。</translation>
    </message>
    <message>
        <source>%1 is about %2 early.</source>
        <translation>%1 は約 %2 早くなっています。</translation>
    </message>
    <message>
        <source>The calibration seems to be in %1.</source>
        <translation>キャリブレーションの単位が%1になっているようです。</translation>
    </message>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 と %2 の姿勢が同じです。</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>%1 と %2 を入れ替える</translation>
    </message>
    <message>
        <source>Set the delay of %1</source>
        <translation>%1 の遅れを設定</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 を回転</translation>
    </message>
    <message>
        <source>Convert to meters</source>
        <translation>メートルに換算</translation>
    </message>
</context>
<context>
    <name>CameraMotion</name>
    <message>
        <source>turned by %1</source>
        <translation>%1 回転</translation>
    </message>
</context>
<context>
    <name>CameraNames</name>
    <message>
        <source>camera %1</source>
        <translation>カメラ %1</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
</context>
<context>
    <name>ClickRadiusText</name>
    <message>
        <source>Its radius seems to be about %1.</source>
        <translation>半径は約 %1 のようです。</translation>
    </message>
    <message>
        <source>Its radius seems to be about %1, but %2 is given. Is that its diameter?</source>
        <translation>半径は約 %1 のようですが、%2 と指定されています。それは直径ではありませんか?</translation>
    </message>
    <message>
        <source>Its radius seems to be about %1, but %2 is given.</source>
        <translation>半径は約 %1 のようですが、%2 と指定されています。</translation>
    </message>
    <message>
        <source>This is a part of something larger of its color: it is followed as a ball with a radius of %1, from where it was marked.</source>
        <translation>これは同じ色のより大きな物の一部です。印を付けた場所から、半径%1の球として追跡します。</translation>
    </message>
</context>
<context>
    <name>ColorLearner</name>
    <message>
        <source>target %1</source>
        <translation>ターゲット %1</translation>
    </message>
</context>
<context>
    <name>ColorText</name>
    <message>
        <source>at the top left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>at the top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>at the top right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>at the left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>in the middle</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>at the right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>at the bottom left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>at the bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>at the bottom right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>Stands out well: %1 of 100.</source>
        <translation>よく見分けられます: 100点中%1点。</translation>
    </message>
    <message>
        <source>Stands out: %1 of 100.</source>
        <translation>見分けられます: 100点中%1点。</translation>
    </message>
    <message>
        <source>Hard to tell apart: %1 of 100.</source>
        <translation>見分けにくい色です: 100点中%1点。</translation>
    </message>
    <message>
        <source>Hardly stands out: %1 of 100.</source>
        <translation>ほとんど見分けられません: 100点中%1点。</translation>
    </message>
    <message>
        <source>black</source>
        <translation>黒い物</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>灰色の物</translation>
    </message>
    <message>
        <source>white</source>
        <translation>白い物</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>茶色の物</translation>
    </message>
    <message>
        <source>red</source>
        <translation>赤い物</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>オレンジ色の物</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>黄色い物</translation>
    </message>
    <message>
        <source>green</source>
        <translation>緑の物</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>青緑の物</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>青い物</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>紫の物</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>ピンクの物</translation>
    </message>
    <message>
        <source>Much of the target does not match: Shift-click its light and its dark side.</source>
        <translation>ターゲットの多くが一致しません。明るい側と暗い側を Shift クリックしてください。</translation>
    </message>
    <message>
        <source>Alt-click what matches too: it can be told apart.</source>
        <translation>一致している別の物を Alt クリックすると区別できます。</translation>
    </message>
    <message>
        <source>Cover what has the same color, or take it out of view.</source>
        <translation>同じ色の物を覆うか、画面の外に出してください。</translation>
    </message>
    <message>
        <source>The target is nearly black here: more light would help.</source>
        <translation>ターゲットがほぼ黒く写っています。明るくすると良くなります。</translation>
    </message>
    <message>
        <source>The target is nearly white here: a shorter exposure would help.</source>
        <translation>ターゲットがほぼ白く写っています。露光を短くすると良くなります。</translation>
    </message>
    <message>
        <source>The target is nearly gray: a stronger color would help.</source>
        <translation>ターゲットがほぼ灰色です。もっと鮮やかな色が良いでしょう。</translation>
    </message>
    <message>
        <source>This fills much of the image: click the thing itself, or drag a box on it.</source>
        <translation>画像の大部分を占めています。物そのものをクリックするか、枠で囲んでください。</translation>
    </message>
    <message>
        <source>%1 % of the images match. Shift-click the target to learn how well it stands out.</source>
        <translation>画像の %1 % が一致します。ターゲットを Shift クリックすると、どれだけ見分けやすいか分かります。</translation>
    </message>
    <message>
        <source>%1 % of the background matches too.</source>
        <translation>背景の %1 % も一致します。</translation>
    </message>
    <message>
        <source>One sample hardly matches the learned color: much around it looks the same, or it shows something else.</source>
        <translation>学習した色にほとんど合わない見本があります。周りにも同じ色があるか、別のものを示しています。</translation>
    </message>
    <message>
        <source>Something %1 %2 of %3 matches too.</source>
        <translation>%3 の%2にある%1も一致します。</translation>
    </message>
    <message>
        <source>Several things have this color: another one would help.</source>
        <translation>この色の物がいくつもあります。別の色にするとよいでしょう。</translation>
    </message>
    <message>
        <source>Only a speck was clicked: drag a box on the whole thing.</source>
        <translation>小さな点だけがクリックされました。物全体を枠で囲んでください。</translation>
    </message>
    <message>
        <source>Only %1 % of the target and %2 % of the background match.</source>
        <translation>ターゲットの %1 % と背景の %2 % だけが一致します。</translation>
    </message>
    <message>
        <source>A range for all of the target would match %1 % of the background.</source>
        <translation>ターゲット全体を含む範囲は、背景の %1 % にも一致します。</translation>
    </message>
    <message numerus="yes">
        <source>%n things have this color and size: follow all of them, or cover the others.</source>
        <translation>
            <numerusform>この色と大きさの物が %n 個あります: すべて追跡するか、ほかの物を覆ってください。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Convergence</name>
    <message>
        <source>Convergence</source>
        <translation>収束</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>広がり</translation>
    </message>
    <message>
        <source>Convergence in frame %1 (%2)</source>
        <comment>number of a frame, unit</comment>
        <translation>フレーム %1 の収束（%2）</translation>
    </message>
    <message>
        <source>Spread of the particles after each iteration on this frame. The filter has converged where the curve levels off.</source>
        <translation>このフレームの各反復の後の粒子のばらつき。曲線が平らになる所で、フィルターは収束しています。</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>cannot be written</source>
        <translation>書き込めません</translation>
    </message>
    <message>
        <source>does not fit the rest</source>
        <translation>ほかの内容と合いません</translation>
    </message>
    <message>
        <source>ended before its announced end</source>
        <translation>示された終わりより前に途切れました</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失敗しました</translation>
    </message>
    <message>
        <source>not a usable value</source>
        <translation>使えない値です</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>要求により中止しました</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>カメラを開けません</translation>
    </message>
    <message>
        <source>the camera stopped delivering images</source>
        <translation>カメラから画像が届かなくなりました</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>ファイルを読み込めません</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>the observations do not settle it</source>
        <translation>観測からは決まりません</translation>
    </message>
    <message>
        <source>the text cannot be understood</source>
        <translation>内容を解釈できません</translation>
    </message>
    <message>
        <source>there is nothing of this name</source>
        <translation>この名前のものはありません</translation>
    </message>
    <message>
        <source>this key is missing</source>
        <translation>このキーがありません</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>不明なキーです</translation>
    </message>
    <message>
        <source>wrong type of value</source>
        <translation>値の型が違います</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>Barrera et al. 2005, figure 3: the particles projected into both cameras while the cloud finds the ball.</source>
        <translation>Barrera ら 2005、図3:雲がボールを見つけるまで、両カメラに投影したパーティクル。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 4: the same cloud from above.</source>
        <translation>Barrera ら 2005、図4:同じ雲を上から見たもの。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 6: the object jumps 2 m at iteration 30.</source>
        <translation>Barrera ら 2005、図6:30回目の反復で物体が2 m移動します。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 7: the same for motion sigmas from 0.001 to 0.3 m, as an image.</source>
        <translation>Barrera ら 2005、図7:モーションシグマ0.001〜0.3 mについて画像で示します。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 8: the cloud at six instants, with a small and a large motion sigma.</source>
        <translation>Barrera ら 2005、図8:小さいシグマと大きいシグマでの6時点の雲。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: start volume against the share of runs that converge, and starts beyond the ball.</source>
        <translation>Barrera ら 2005、III-B節:開始体積と収束した割合、ボールの向こうからの開始。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: with one camera the cloud moves away from it.</source>
        <translation>Barrera ら 2005、III-B節:カメラ1台では雲がそこから遠ざかります。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 5: where one camera alone finds the color, and why the cloud moves away from it.</source>
        <translation>Barrera ら 2005、図5:カメラ1台だけで色が見つかる範囲と、雲がそこから遠ざかる理由。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009, figures 1 and 3: what moves in the images of a camera, in pieces, and how likely that makes a person at each pixel.</source>
        <translation>Mohedano ら 2009、図1と図3:カメラの画像で動く部分(断片的)と、それによる各画素での人物の確からしさ。</translation>
    </message>
    <message>
        <source>Drift along the optical axis</source>
        <translation>光軸方向のドリフト</translation>
    </message>
    <message>
        <source>Error after a jump</source>
        <translation>ジャンプ後の誤差</translation>
    </message>
    <message>
        <source>Error over iteration and motion sigma</source>
        <translation>反復とモーションシグマに対する誤差</translation>
    </message>
    <message>
        <source>Particles from above</source>
        <translation>上から見たパーティクル</translation>
    </message>
    <message>
        <source>Particles in both images</source>
        <translation>両画像のパーティクル</translation>
    </message>
    <message>
        <source>The cloud on its way</source>
        <translation>移動中の雲</translation>
    </message>
    <message>
        <source>Motion masks and motion likelihood</source>
        <translation>動きのマスクと動きの尤度</translation>
    </message>
    <message>
        <source>The cone of one camera</source>
        <translation>カメラ1台の円錐</translation>
    </message>
    <message>
        <source>Where the cloud may start</source>
        <translation>雲の開始位置</translation>
    </message>
    <message>
        <source>Boxes: error, success and precision</source>
        <translation>枠：誤差、成功率、精度</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people come and go; how long an estimate belongs to nobody, and how long a person has no estimate.</source>
        <translation>Mohedano ら 2009：人が出入りします。誰のものでもない推定が続く時間と、人に推定がない時間を調べます。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet and walk on; motion alone may confuse them, color keeps them apart when their clothes differ.</source>
        <translation>Mohedano ら 2009：2 人が出会って通り過ぎます。動きだけでは取り違えることがあり、服が違えば色で区別できます。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet, stay and go back where they came from.</source>
        <translation>Mohedano ら 2009：2 人が出会い、立ち止まり、来た方へ戻ります。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people walk close to each other.</source>
        <translation>Mohedano ら 2009：2 人が近くを並んで歩きます。</translation>
    </message>
    <message>
        <source>People side by side</source>
        <translation>並んで歩く人</translation>
    </message>
    <message>
        <source>People who cross</source>
        <translation>すれ違う人</translation>
    </message>
    <message>
        <source>People who enter and leave</source>
        <translation>入って出て行く人</translation>
    </message>
    <message>
        <source>People who meet and turn</source>
        <translation>出会って引き返す人</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009, section 4: 100 and 300 particles, method histogram and four trackers of OpenCV on the same clips.</source>
        <translation>Sugandi ら 2009、第 4 節：粒子 100 個と 300 個、手法 histogram、OpenCV の 4 つの追跡器を同じ映像で比べます。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people far from each other, the easy case, in which no method may mix them up.</source>
        <translation>Mohedano ほか 2009: 互いに離れた二人。どの方法も取り違えてはならない易しい場合。</translation>
    </message>
    <message>
        <source>People who stay apart</source>
        <translation>離れたままの人々</translation>
    </message>
    <message>
        <source>Barrera et al. 2005: a ball in space</source>
        <translation>Barrera ら 2005：空間中のボール</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009: boxes in one camera</source>
        <translation>Sugandi ら 2009：1 台のカメラでの枠</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people</source>
        <translation>Mohedano ら 2009：人物</translation>
    </message>
    <message>
        <source>More scenes of people</source>
        <translation>その他の人物の場面</translation>
    </message>
    <message>
        <source>People of different heights</source>
        <translation>身長の異なる人</translation>
    </message>
    <message>
        <source>A child of 0.9 to 1.3 m, one person of 1.3 to 1.6 m and one of 1.88 to 2 m walk about.</source>
        <translation>0.9～1.3 m の子ども、1.3～1.6 m の人、1.88～2 m の人が歩き回ります。</translation>
    </message>
    <message>
        <source>People who sit and crouch</source>
        <translation>座る人としゃがむ人</translation>
    </message>
    <message>
        <source>One person sits down on a stool and rises, one crouches and rises, and one walks by.</source>
        <translation>1 人がスツールに座って立ち上がり、1 人がしゃがんで立ち上がり、1 人が通り過ぎます。</translation>
    </message>
    <message>
        <source>People who carry things</source>
        <translation>物を運ぶ人</translation>
    </message>
    <message>
        <source>Two people walk past each other, one with a box before the chest, one with a bag.</source>
        <translation>2 人がすれ違います。1 人は胸の前に箱を、1 人はかばんを持っています。</translation>
    </message>
    <message>
        <source>A crowd</source>
        <translation>人混み</translation>
    </message>
    <message>
        <source>Five to eight people mill about for 12 s; their paths may touch and cross.</source>
        <translation>5～8 人が 12 秒間動き回ります。進路は触れたり交わったりします。</translation>
    </message>
    <message>
        <source>People seen by two cameras</source>
        <translation>2 台のカメラに映る人</translation>
    </message>
    <message>
        <source>Two people walk past each other, seen by only two of the four cameras.</source>
        <translation>2 人がすれ違います。4 台のカメラのうち 2 台だけに映ります。</translation>
    </message>
    <message>
        <source>People who come close</source>
        <translation>ごく近くまで近づく人</translation>
    </message>
    <message>
        <source>Two people come within 0.15 to 0.28 m of each other, stand there, and go back.</source>
        <translation>2 人が 0.15～0.28 m まで近づき、立ち止まって戻ります。</translation>
    </message>
    <message>
        <source>Furniture that moves</source>
        <translation>動く家具</translation>
    </message>
    <message>
        <source>A cabinet and a stool are moved after the cameras have learned the background.</source>
        <translation>カメラが背景を学習した後で、戸棚とスツールが動かされます。</translation>
    </message>
    <message>
        <source>Clothes like the room</source>
        <translation>部屋と似た服</translation>
    </message>
    <message>
        <source>Two people in clothes of the colors of walls, furniture and floor walk past each other.</source>
        <translation>壁、家具、床と同じ色の服を着た 2 人がすれ違います。</translation>
    </message>
    <message>
        <source>Patterned clothes</source>
        <translation>柄のある服</translation>
    </message>
    <message>
        <source>Two people in striped, checked or blotched shirts walk past each other.</source>
        <translation>縞、格子、斑の柄のシャツを着た 2 人がすれ違います。</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>CSV, one row per target and time</source>
        <translation>CSV（ターゲットと時刻ごとに1行）</translation>
    </message>
    <message>
        <source>CSV, one row per time (spreadsheets)</source>
        <translation>CSV（時刻ごとに1行、表計算用）</translation>
    </message>
    <message>
        <source>TUM (evo)</source>
        <translation>TUM（evo）</translation>
    </message>
    <message>
        <source>TRC (OpenSim)</source>
        <translation>TRC（OpenSim）</translation>
    </message>
    <message>
        <source>C3D (motion capture)</source>
        <translation>C3D（モーションキャプチャ）</translation>
    </message>
    <message>
        <source>NPZ (NumPy)</source>
        <translation>NPZ（NumPy）</translation>
    </message>
    <message>
        <source>VTP (ParaView, paths)</source>
        <translation>VTP（ParaView、軌跡）</translation>
    </message>
    <message>
        <source>PVD (ParaView, over time)</source>
        <translation>PVD（ParaView、時系列）</translation>
    </message>
    <message>
        <source>JSON lines</source>
        <translation>JSON 行形式</translation>
    </message>
    <message>
        <source>Z points up, axes as in the project</source>
        <translation>Z が上向き、軸はプロジェクトと同じ</translation>
    </message>
    <message>
        <source>Y points up: x, y, z are y, z, x of the project</source>
        <translation>Y が上向き: x, y, z はプロジェクトの y, z, x</translation>
    </message>
    <message>
        <source>Lengths in %1, times in s, covariances in %1². %2.</source>
        <translation>長さは %1、時刻は s、共分散は %1²。%2。</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>欠落なし</translation>
    </message>
    <message>
        <source>%1 places unknown</source>
        <translation>不明な位置 %1</translation>
    </message>
    <message>
        <source>Targets: %1, rows: %2 at %3 per second, %4.</source>
        <translation>ターゲット: %1、行: %2（毎秒 %3）、%4。</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Wrote the figure %1.</source>
        <translation>図 %1 を書き出しました。</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2 files; the last is %3.</source>
        <translation>%1 行を %2 個のファイルに書き出しました。最後は %3 です。</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2.</source>
        <translation>%1 行を %2 に書き出しました。</translation>
    </message>
</context>
<context>
    <name>GlContext</name>
    <message>
        <source>no OpenGL context can be made on this display</source>
        <translation>この画面では OpenGL コンテキストを作成できません</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used</source>
        <translation>OpenGL コンテキストを使用できません</translation>
    </message>
    <message>
        <source>OpenGL 3.2 is needed</source>
        <translation>OpenGL 3.2 が必要です</translation>
    </message>
</context>
<context>
    <name>HoldState</name>
    <message>
        <source>● held</source>
        <translation>● 追跡中</translation>
    </message>
    <message>
        <source>○ searching</source>
        <translation>○ 探索中</translation>
    </message>
    <message>
        <source>▲ lost</source>
        <translation>▲ 見失い</translation>
    </message>
    <message>
        <source>✕ missing</source>
        <translation>✕ なし</translation>
    </message>
    <message>
        <source>– no images</source>
        <translation>– 画像なし</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>ターゲットなし</translation>
    </message>
    <message>
        <source>– not tracked</source>
        <translation>– 未追跡</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ 隠れている</translation>
    </message>
    <message>
        <source>– no box</source>
        <translation>– 枠なし</translation>
    </message>
    <message>
        <source>◔ learning the room</source>
        <translation>◔ 部屋を学習中</translation>
    </message>
    <message>
        <source>◌ nobody there</source>
        <translation>◌ 誰もいません</translation>
    </message>
    <message>
        <source>– not there</source>
        <translation>– 不在</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ あいまい</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>%1 or more</source>
        <translation>%1台以上</translation>
    </message>
    <message>
        <source>blank: none</source>
        <translation>空白：なし</translation>
    </message>
    <message>
        <source>blank: fewer than two cameras</source>
        <translation>空白：2台未満</translation>
    </message>
    <message>
        <source>Cameras that see it</source>
        <translation>見えるカメラの数</translation>
    </message>
    <message>
        <source>Expected error (1 σ)</source>
        <translation>予想誤差（1 σ）</translation>
    </message>
</context>
<context>
    <name>MapOverlay</name>
    <message>
        <source>Cameras that see it: %1</source>
        <translation>見えるカメラ：%1台</translation>
    </message>
    <message>
        <source>±%1 (1 σ); cameras that see it: %2</source>
        <translation>±%1（1 σ）、見えるカメラ：%2台</translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>A box in one video</source>
        <translation>1 本の動画の中の枠</translation>
    </message>
    <message>
        <source>A particle filter on color histograms</source>
        <translation>色ヒストグラムのパーティクルフィルタ</translation>
    </message>
    <message>
        <source>A particle filter on positions</source>
        <translation>位置のパーティクルフィルタ</translation>
    </message>
    <message>
        <source>A plain particle filter on color</source>
        <translation>色の単純なパーティクルフィルタ</translation>
    </message>
    <message>
        <source>Anything colored, in 3D</source>
        <translation>色のついた物を 3D で</translation>
    </message>
    <message>
        <source>Anything you draw a box around</source>
        <translation>枠で囲んだ物なら何でも</translation>
    </message>
    <message>
        <source>Balls, hands, anything colored</source>
        <translation>ボール、手、色のついた物なら何でも</translation>
    </message>
    <message>
        <source>Follows its colors and its size, and finds it again after it was hidden.</source>
        <translation>色と大きさの変化を追い、隠れた後も見つけ直します。</translation>
    </message>
    <message>
        <source>For comparison: confuses people who come close.</source>
        <translation>比較用：近づいた人を取り違えます。</translation>
    </message>
    <message>
        <source>For comparison: tells people apart by different clothes.</source>
        <translation>比較用：服の違いで人を区別します。</translation>
    </message>
    <message>
        <source>For teaching: follows a box in one video.</source>
        <translation>教育用：1 本の動画の中の枠を追います。</translation>
    </message>
    <message>
        <source>For teaching: shows how a particle filter works.</source>
        <translation>教育用：パーティクルフィルタの仕組みを示します。</translation>
    </message>
    <message>
        <source>For teaching: shows how particles follow measurements.</source>
        <translation>教育用：粒子が測定を追う様子を示します。</translation>
    </message>
    <message>
        <source>From papers, for teaching and comparison</source>
        <translation>論文の手法（教育と比較のために）</translation>
    </message>
    <message>
        <source>People by motion alone</source>
        <translation>動きだけによる人物</translation>
    </message>
    <message>
        <source>People by motion and color</source>
        <translation>動きと色による人物</translation>
    </message>
    <message>
        <source>People in a room</source>
        <translation>部屋の中の人物</translation>
    </message>
    <message>
        <source>People who walk and meet</source>
        <translation>歩き、出会う人物</translation>
    </message>
    <message>
        <source>Positions on the floor of several people, also in similar clothes.</source>
        <translation>似た服を着ていても、複数の人物の床の上の位置を求めます。</translation>
    </message>
    <message>
        <source>The most accurate: decides by itself between a ball and any other shape.</source>
        <translation>最も正確：ボールかほかの形かを自動で判断します。</translation>
    </message>
</context>
<context>
    <name>MethodObstacle</name>
    <message>
        <source>Needs calibrated cameras.</source>
        <translation>キャリブレーション済みのカメラが必要です。</translation>
    </message>
    <message>
        <source>Needs at least two cameras.</source>
        <translation>2 台以上のカメラが必要です。</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Half the x size of the box around the start in which particles start evenly spread; 0 starts them all at the same x.</source>
        <translation>開始点を囲む箱の x 方向の大きさの半分。粒子はこの箱の中に一様に散らばって始まります。0 ではすべて同じ x から始まります。</translation>
    </message>
    <message>
        <source>Half the y size of the box around the start in which particles start evenly spread; 0 starts them all at the same y.</source>
        <translation>開始点を囲む箱の y 方向の大きさの半分。粒子はこの箱の中に一様に散らばって始まります。0 ではすべて同じ y から始まります。</translation>
    </message>
    <message>
        <source>Half the z size of the box around the start in which particles start evenly spread; 0 starts them all at the same z.</source>
        <translation>開始点を囲む箱の z 方向の大きさの半分。粒子はこの箱の中に一様に散らばって始まります。0 ではすべて同じ z から始まります。</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis in one iteration: larger follows faster objects and spreads wider.</source>
        <translation>1 回の反復で粒子が各軸方向にランダムに動く大きさ。大きいほど速い物体を追えますが、粒子は広く散らばります。</translation>
    </message>
    <message>
        <source>How many filter iterations run on each frame.</source>
        <translation>1 フレームごとに実行するフィルターの反復回数。</translation>
    </message>
    <message>
        <source>How many particles the filter uses: more follow more surely and cost more time.</source>
        <translation>フィルターが使う粒子の数。多いほど確実に追跡できますが、時間がかかります。</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>フレームごとの反復</translation>
    </message>
    <message>
        <source>Motion sigma</source>
        <translation>動きのシグマ</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子数</translation>
    </message>
    <message>
        <source>Start half-size x</source>
        <translation>開始範囲の半分 x</translation>
    </message>
    <message>
        <source>Start half-size y</source>
        <translation>開始範囲の半分 y</translation>
    </message>
    <message>
        <source>Start half-size z</source>
        <translation>開始範囲の半分 z</translation>
    </message>
    <message>
        <source>Start x</source>
        <translation>開始位置 x</translation>
    </message>
    <message>
        <source>Start y</source>
        <translation>開始位置 y</translation>
    </message>
    <message>
        <source>Start z</source>
        <translation>開始位置 z</translation>
    </message>
    <message>
        <source>World x of the place where all particles start.</source>
        <translation>すべての粒子が始まる場所の世界座標 x。</translation>
    </message>
    <message>
        <source>World y of the place where all particles start.</source>
        <translation>すべての粒子が始まる場所の世界座標 y。</translation>
    </message>
    <message>
        <source>World z of the place where all particles start.</source>
        <translation>すべての粒子が始まる場所の世界座標 z。</translation>
    </message>
    <message>
        <source>Acceleration sigma</source>
        <translation>加速度のシグマ</translation>
    </message>
    <message>
        <source>Edge of the room in which a target may appear: larger asks for more evidence before a target is believed.</source>
        <translation>目標が現れうる空間の一辺の長さ。大きいほど、目標があると判断するまでに多くの証拠が必要になります。</translation>
    </message>
    <message>
        <source>Fewest particles</source>
        <translation>最小粒子数</translation>
    </message>
    <message>
        <source>How far the particles may be from the distribution they stand for (Kullback-Leibler distance): smaller takes more particles where they disagree; 0 always takes all of them.</source>
        <translation>粒子が、それらの表す分布からどれだけ離れてよいか（カルバック・ライブラー距離）。小さいほど、粒子がばらつく所で多くの粒子を使います。0 では常にすべてを使います。</translation>
    </message>
    <message>
        <source>How long a target that no camera can judge is believed to be still there.</source>
        <translation>どのカメラからも判断できない目標を、まだそこにあるとみなす時間。</translation>
    </message>
    <message>
        <source>How many particles each target uses at least, when they all agree.</source>
        <translation>すべての粒子がそろっているときに、各目標が使う粒子の最小数。</translation>
    </message>
    <message>
        <source>How many particles each target uses at most.</source>
        <translation>各目標が使う粒子の最大数。</translation>
    </message>
    <message>
        <source>How strongly targets speed up, slow down and turn: larger follows abrupt motion, smaller bridges gaps better.</source>
        <translation>目標がどれだけ強く加速、減速、方向転換するか。大きいほど急な動きを追え、小さいほど途切れをうまく補えます。</translation>
    </message>
    <message>
        <source>Sampling error</source>
        <translation>標本誤差</translation>
    </message>
    <message>
        <source>Search size</source>
        <translation>探索範囲の大きさ</translation>
    </message>
    <message>
        <source>Survival time</source>
        <translation>存続時間</translation>
    </message>
    <message>
        <source>Time budget</source>
        <translation>時間の上限</translation>
    </message>
    <message>
        <source>How long one iteration may take: fewer particles are used, and searches are spread over several frames, to keep to it. 0 sets no limit; with a limit a run depends on the speed of the machine and cannot be repeated bit by bit.</source>
        <translation>1 回の反復にかけてよい時間です。これを守るために粒子を減らし、探索を複数のフレームに分けます。0 は上限なしです。上限があると、実行はマシンの速度に左右され、ビット単位では再現できません。</translation>
    </message>
    <message>
        <source>Color adaptation</source>
        <translation>色の追従</translation>
    </message>
    <message>
        <source>How fast a target&apos;s color range follows slow changes of light, as a time constant; only while the target is surely there, and in each camera by itself. 0 keeps the range as it is; 2 is a good value in a room with daylight.</source>
        <translation>ターゲットの色範囲が光のゆっくりした変化に追従する速さ(時定数)。ターゲットが確かに見えている間だけ、カメラごとに追従します。0では範囲は変わりません。自然光の入る部屋では2が適しています。</translation>
    </message>
    <message>
        <source>How far off a measured position is taken to be along each axis: larger trusts the particles more, smaller the measurement.</source>
        <translation>測定位置の各軸の誤差。大きいほどパーティクルを、小さいほど測定を信頼します。</translation>
    </message>
    <message>
        <source>Observation sigma</source>
        <translation>観測シグマ</translation>
    </message>
    <message>
        <source>Adaptation</source>
        <translation>適応</translation>
    </message>
    <message>
        <source>Aspect sigma</source>
        <translation>縦横比のシグマ</translation>
    </message>
    <message>
        <source>Hidden below</source>
        <translation>これ未満で隠れたとみなす</translation>
    </message>
    <message>
        <source>How different from the reference the colors may be (Bhattacharyya distance): smaller trusts the best particles more.</source>
        <translation>色が基準からどれだけ違ってよいか（バタチャリヤ距離）。小さいほど最良の粒子を重んじます。</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis from image to image, beside going on as before, in sizes of the target.</source>
        <translation>画像ごとに、それまでの動きに加えて、粒子が各軸方向にランダムに動く大きさ。目標の大きさを単位とします。</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis from image to image, beside going on as before: larger follows sudden motion and spreads wider.</source>
        <translation>画像ごとに、それまでの動きに加えて、粒子が各軸方向にランダムに動く大きさ。大きいほど急な動きを追えますが、広く散らばります。</translation>
    </message>
    <message>
        <source>How far the target may be from where it was expected, in sizes of the target, before that counts strongly against a place.</source>
        <translation>目標が予想の場所からどれだけ離れてよいか（目標の大きさを単位とする）。これを超えると、その場所は強く不利になります。</translation>
    </message>
    <message>
        <source>How much better a place with more of the target&apos;s colors is held to be.</source>
        <translation>目標の色がより多い場所を、どれだけ良いとみなすか。</translation>
    </message>
    <message>
        <source>How much the proportion of width to height may change from image to image (logarithm); 0 keeps it as it was given.</source>
        <translation>画像ごとに幅と高さの比がどれだけ変わってよいか（対数）。0 では与えたままです。</translation>
    </message>
    <message>
        <source>How much the size of the box may change from image to image (logarithm); 0 keeps it as it was given.</source>
        <translation>画像ごとに枠の大きさがどれだけ変わってよいか（対数）。0 では与えたままです。</translation>
    </message>
    <message>
        <source>Jump reach</source>
        <translation>飛び先の範囲</translation>
    </message>
    <message>
        <source>Jump share</source>
        <translation>飛び先を試す割合</translation>
    </message>
    <message>
        <source>Likelihood sigma</source>
        <translation>尤度のシグマ</translation>
    </message>
    <message>
        <source>Position sigma</source>
        <translation>位置のシグマ</translation>
    </message>
    <message>
        <source>Scale sigma</source>
        <translation>大きさのシグマ</translation>
    </message>
    <message>
        <source>Share by which the reference colors follow those of the box from image to image; 0 keeps those of the first image.</source>
        <translation>画像ごとに基準の色が枠の色に近づく割合。0 では最初の画像の色のままです。</translation>
    </message>
    <message>
        <source>Share of the particles that are tried at other places with the target&apos;s colors.</source>
        <translation>目標の色がある別の場所で試される粒子の割合。</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>鋭さ</translation>
    </message>
    <message>
        <source>The target counts as hidden, and is held, where less than this share of its usual colors is found.</source>
        <translation>ふだんの色のこの割合未満しか見つからないとき、目標は隠れたとみなされ、その場に保たれます。</translation>
    </message>
    <message>
        <source>1: who is seen by several cameras becomes a person; 0: only people put there by hand.</source>
        <translation>1：複数のカメラに写った人を人物とみなします。0：手で置いた人物だけ。</translation>
    </message>
    <message>
        <source>After how long something new that stays counts as background.</source>
        <translation>動かずに残る新しいものを背景とみなすまでの時間。</translation>
    </message>
    <message>
        <source>Area half size x</source>
        <translation>領域の半分 x</translation>
    </message>
    <message>
        <source>Area half size y</source>
        <translation>領域の半分 y</translation>
    </message>
    <message>
        <source>Area x</source>
        <translation>領域 x</translation>
    </message>
    <message>
        <source>Area y</source>
        <translation>領域 y</translation>
    </message>
    <message>
        <source>Background memory</source>
        <translation>背景の記憶</translation>
    </message>
    <message>
        <source>Background model</source>
        <translation>背景モデル</translation>
    </message>
    <message>
        <source>Birth time</source>
        <translation>出現までの時間</translation>
    </message>
    <message>
        <source>Births</source>
        <translation>人物の出現</translation>
    </message>
    <message>
        <source>Body points</source>
        <translation>体の点の数</translation>
    </message>
    <message>
        <source>Color noise</source>
        <translation>色のノイズ</translation>
    </message>
    <message>
        <source>Color weight</source>
        <translation>色の重み</translation>
    </message>
    <message>
        <source>Darkest shadow</source>
        <translation>最も暗い影</translation>
    </message>
    <message>
        <source>Evidence per camera</source>
        <translation>カメラごとの証拠</translation>
    </message>
    <message>
        <source>Floor z</source>
        <translation>床の z</translation>
    </message>
    <message>
        <source>Half the size of the floor that is watched; who crosses its border has left.</source>
        <translation>見張る床の大きさの半分。境界を越えた人は立ち去ったとみなします。</translation>
    </message>
    <message>
        <source>Height of a person whose own is not known yet.</source>
        <translation>身長がまだ分からない人物の身長。</translation>
    </message>
    <message>
        <source>Height of the floor in the world frame.</source>
        <translation>世界座標系での床の高さ。</translation>
    </message>
    <message>
        <source>How long a person whom no two cameras see is believed to be still there.</source>
        <translation>2 台のカメラに写っていない人物を、まだそこにいるとみなす時間。</translation>
    </message>
    <message>
        <source>How long foreground that nobody explains must stay together to become a person.</source>
        <translation>誰のものでもない前景が、人物とみなされるまで続く必要のある時間。</translation>
    </message>
    <message>
        <source>How long the cameras only learn what they usually show, at first; nobody should be there.</source>
        <translation>最初に、カメラがふだんの眺めだけを学習する時間。その間は誰もいないようにします。</translation>
    </message>
    <message>
        <source>How many particles each person has.</source>
        <translation>1 人あたりの粒子の数。</translation>
    </message>
    <message>
        <source>How many points stand for the volume of each person.</source>
        <translation>各人物の体積を表す点の数。</translation>
    </message>
    <message>
        <source>How moving regions are found: 0 one Gaussian per pixel (fast), 1 OpenCV&apos;s MOG2, 2 OpenCV&apos;s KNN.</source>
        <translation>動く領域の見つけ方：0 画素ごとに 1 つのガウス分布（高速）、1 OpenCV の MOG2、2 OpenCV の KNN。</translation>
    </message>
    <message>
        <source>How much a camera that sees a whole person says: larger trusts the masks more.</source>
        <translation>全身が写ったカメラの発言の重さ。大きいほどマスクを信用します。</translation>
    </message>
    <message>
        <source>How much the colors of clothes count beside the masks when people are near each other.</source>
        <translation>人が近くにいるとき、マスクに対して服の色をどれだけ重んじるか。</translation>
    </message>
    <message>
        <source>How near the middles of two people can come.</source>
        <translation>2 人の体の中心がどこまで近づけるか。</translation>
    </message>
    <message>
        <source>How strongly people speed up, slow down and turn.</source>
        <translation>人がどれだけ強く加速、減速、方向転換するか。</translation>
    </message>
    <message>
        <source>Hue floor</source>
        <translation>色相の下限</translation>
    </message>
    <message>
        <source>Hue sigma</source>
        <translation>色相のシグマ</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Images are reduced to at most this width before anything else; 0 keeps them as they are.</source>
        <translation>最初に画像をこの幅まで縮小します。0 では縮小しません。</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>学習時間</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>最小距離</translation>
    </message>
    <message>
        <source>Least likelihood of a hue (the paper&apos;s h_B): something else may be seen.</source>
        <translation>色相の尤度の下限（論文の h_B）：別のものが写っているかもしれません。</translation>
    </message>
    <message>
        <source>Least likelihood of a saturation (the paper&apos;s s_B).</source>
        <translation>彩度の尤度の下限（論文の s_B）。</translation>
    </message>
    <message>
        <source>Least likelihood where a camera sees no motion (the paper&apos;s p_B: 0.2).</source>
        <translation>カメラに動きが写らない所での尤度の下限（論文の p_B：0.2）。</translation>
    </message>
    <message>
        <source>Mask smoothing</source>
        <translation>マスクの平滑化</translation>
    </message>
    <message>
        <source>Middle of the floor that is watched.</source>
        <translation>見張る床の中心。</translation>
    </message>
    <message>
        <source>Motion floor</source>
        <translation>動きの下限</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>位置のノイズ</translation>
    </message>
    <message>
        <source>Saturation floor</source>
        <translation>彩度の下限</translation>
    </message>
    <message>
        <source>Saturation sigma</source>
        <translation>彩度のシグマ</translation>
    </message>
    <message>
        <source>Sigma of the Gaussian that smooths the motion masks (the paper: 4 px).</source>
        <translation>動きのマスクを平滑化するガウス関数のシグマ（論文では 4 px）。</translation>
    </message>
    <message>
        <source>Standard deviation of a measured hue, in [0, 1].</source>
        <translation>測った色相の標準偏差（0 から 1）。</translation>
    </message>
    <message>
        <source>Standard deviation of a measured saturation, in [0, 1].</source>
        <translation>測った彩度の標準偏差（0 から 1）。</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each component of the velocity, per frame.</source>
        <translation>1 フレームごとに速度の各成分へ加えるノイズの標準偏差。</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each coordinate, per frame.</source>
        <translation>1 フレームごとに各座標へ加えるノイズの標準偏差。</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on hue and saturation, per frame.</source>
        <translation>1 フレームごとに色相と彩度へ加えるノイズの標準偏差。</translation>
    </message>
    <message>
        <source>Usual height</source>
        <translation>ふつうの身長</translation>
    </message>
    <message>
        <source>Velocity noise</source>
        <translation>速度のノイズ</translation>
    </message>
    <message>
        <source>What is darker than usual by no more than this factor, in the same tint, is a shadow.</source>
        <translation>ふだんと同じ色合いで、暗さがこの倍率以内のものは影とみなします。</translation>
    </message>
    <message>
        <source>Calibration error</source>
        <translation>キャリブレーション誤差</translation>
    </message>
    <message>
        <source>How far off the directions are in which the cameras see things. The stated uncertainty of a position includes it. 0.25 suits a calibration by hand.</source>
        <translation>カメラが物を見る方向のずれ。表示される位置の不確かさに含まれます。手動キャリブレーションには 0.25 が適しています。</translation>
    </message>
    <message>
        <source>How far off the times of the images are. The stated uncertainty of a moving target includes it. 8 suits webcams.</source>
        <translation>画像の時刻のずれ。動くターゲットの表示される不確かさに含まれます。ウェブカメラには 8 が適しています。</translation>
    </message>
    <message>
        <source>Time error</source>
        <translation>時刻の誤差</translation>
    </message>
</context>
<context>
    <name>ParameterGroup</name>
    <message>
        <source>Area and people</source>
        <translation>領域と人物</translation>
    </message>
    <message>
        <source>Essential</source>
        <translation>基本</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>上級</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>Search and start</source>
        <translation>探索と開始</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>%1
From %2 to %3%4; default %5%4.</source>
        <translation>%1
%2 から %3%4 まで。既定値は %5%4。</translation>
    </message>
    <message>
        <source>%1
From %2 to %3%4; what the cameras see unless you change it.</source>
        <translation>%1
%2 から %3%4 まで。変更しない限り、カメラに映る範囲。</translation>
    </message>
    <message>
        <source>Changed: the default is %1.</source>
        <translation>変更済み：既定値は %1 です。</translation>
    </message>
    <message>
        <source>Reset to %1 (Backspace on the slider)</source>
        <translation>%1 に戻す（スライダー上で Backspace）</translation>
    </message>
</context>
<context>
    <name>People</name>
    <message>
        <source>learning the empty room: %1 % · keep out of view</source>
        <translation>空の部屋を学習中：%1 % · 画面に入らないでください</translation>
    </message>
    <message>
        <source>%1 % of the image moves: not looked at</source>
        <translation>画像の %1 % が動いています：使いません</translation>
    </message>
    <message>
        <source>learning: %1 %</source>
        <translation>学習中：%1 %</translation>
    </message>
</context>
<context>
    <name>PlotAxisStrip</name>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>反復</translation>
    </message>
</context>
<context>
    <name>PlotFigure</name>
    <message>
        <source>time, s</source>
        <translation>時間, s</translation>
    </message>
    <message>
        <source>filter iteration</source>
        <translation>フィルタ反復</translation>
    </message>
    <message>
        <source>Dewpoint plots</source>
        <translation>Dewpoint のグラフ</translation>
    </message>
</context>
<context>
    <name>PlotQuantity</name>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>title of a plot, unit of its axis</comment>
        <translation>%1（%2）</translation>
    </message>
</context>
<context>
    <name>PlotReadout</name>
    <message>
        <source>truth</source>
        <translation>真値</translation>
    </message>
</context>
<context>
    <name>Quantity</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>no image</source>
        <translation>画像なし</translation>
    </message>
    <message>
        <source>covered or moved</source>
        <translation>覆われたか動いた</translation>
    </message>
    <message>
        <source>too dark</source>
        <translation>暗すぎる</translation>
    </message>
    <message>
        <source>out of view</source>
        <translation>視野の外</translation>
    </message>
    <message>
        <source>partly hidden</source>
        <translation>一部が隠れている</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隠れている</translation>
    </message>
    <message>
        <source>at a look-alike</source>
        <translation>似た物の位置</translation>
    </message>
    <message>
        <source>%1 beside a look-alike</source>
        <translation>似た物から %1</translation>
    </message>
    <message>
        <source>no color matches</source>
        <translation>一致する色なし</translation>
    </message>
    <message>
        <source>its color is %1 away</source>
        <translation>その色は %1 離れている</translation>
    </message>
    <message>
        <source>its color, but not its shape</source>
        <translation>色は合うが形が違う</translation>
    </message>
    <message>
        <source>hidden here</source>
        <translation>ここでは隠れている</translation>
    </message>
    <message>
        <source>not in this picture</source>
        <translation>この画像に写っていない</translation>
    </message>
</context>
<context>
    <name>RunPlots</name>
    <message>
        <source>all cameras</source>
        <translation>全カメラ</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>広がり</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>有効サンプルサイズ</translation>
    </message>
    <message>
        <source>effective</source>
        <translation>有効</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Log likelihood</source>
        <translation>対数尤度</translation>
    </message>
    <message>
        <source>Existence</source>
        <translation>存在確率</translation>
    </message>
    <message>
        <source>Error against truth</source>
        <translation>真値との誤差</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Time per step</source>
        <translation>1 ステップの時間</translation>
    </message>
    <message>
        <source>one iteration</source>
        <translation>1 反復</translation>
    </message>
    <message>
        <source>Similarity</source>
        <translation>類似度</translation>
    </message>
    <message>
        <source>to the reference</source>
        <translation>基準との</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高さ</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Frame %1, %2</source>
        <translation>フレーム %1、%2</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>未追跡</translation>
    </message>
    <message>
        <source>✕ %1</source>
        <translation>✕ %1</translation>
    </message>
    <message>
        <source>history %1 of %2 MB</source>
        <translation>履歴 %1 / %2 MB</translation>
    </message>
    <message>
        <source>, the last %1</source>
        <translation>、直近 %1</translation>
    </message>
    <message>
        <source>tracking again: frame %1 of %2 to %3</source>
        <translation>再追跡中: フレーム %1 (%2～%3)</translation>
    </message>
    <message>
        <source>✕ cameras</source>
        <translation>✕ カメラ</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>修正済み</translation>
    </message>
    <message>
        <source>of earlier settings</source>
        <translation>以前の設定の結果</translation>
    </message>
    <message>
        <source>How well each target is held appears here when tracking runs.</source>
        <translation>追跡を実行すると、各ターゲットをどれだけ確実に追跡できているかがここに表示されます。</translation>
    </message>
</context>
<context>
    <name>TransportBar</name>
    <message>
        <source>Transport</source>
        <translation>再生の操作</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>m/s²</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>sizes</source>
        <translation>倍（大きさ）</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
</context>
<context>
    <name>WandSettings</name>
    <message>
        <source>touches the floor</source>
        <translation>床に触れている</translation>
    </message>
    <message>
        <source>is at the first end of the distance</source>
        <translation>距離の一方の端にある</translation>
    </message>
    <message>
        <source>is at the second end of the distance</source>
        <translation>距離のもう一方の端にある</translation>
    </message>
    <message>
        <source>begins to fall</source>
        <translation>落ち始める</translation>
    </message>
    <message>
        <source>still falls</source>
        <translation>まだ落ちている</translation>
    </message>
    <message>
        <source>Two cameras or more must see the ball.</source>
        <translation>2台以上のカメラがボールを見る必要があります。</translation>
    </message>
    <message>
        <source>Learn the color of the ball first: press L and click it in an image.</source>
        <translation>まずボールの色を学習させてください。L を押して画像の中のボールをクリックします。</translation>
    </message>
    <message>
        <source>A stick has two balls of different colors: learn the second one (Shift+L).</source>
        <translation>棒には色の違う2つのボールがあります。2つ目を学習させてください (Shift+L)。</translation>
    </message>
    <message>
        <source>The two ends of the stick are the same target: choose another.</source>
        <translation>棒の両端が同じターゲットです。別のものを選んでください。</translation>
    </message>
    <message>
        <source>The size is to come from a distance: take the moments at which the ball is at its two ends.</source>
        <translation>大きさは距離から求めます。ボールがその両端にある瞬間を取り込んでください。</translation>
    </message>
    <message>
        <source>A fall needs two moments: one at which the ball begins to fall, and one at which it still falls.</source>
        <translation>落下には2つの瞬間が必要です。ボールが落ち始める瞬間と、まだ落ちている瞬間です。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AboutDialog</name>
    <message>
        <source>Show license</source>
        <translation>ライセンスを表示</translation>
    </message>
    <message>
        <source>Hide license</source>
        <translation>ライセンスを隠す</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Dewpoint について</translation>
    </message>
    <message>
        <source>Dewpoint %1</source>
        <translation>Dewpoint %1</translation>
    </message>
    <message>
        <source>Tracks colored objects in 3D, live, from ordinary cameras with particle filters.</source>
        <translation>普通のカメラとパーティクルフィルタで、色の付いた物体を 3D でリアルタイムに追跡します。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later (GPL-3.0-or-later), without any warranty.</source>
        <translation>GNU General Public License バージョン 3 以降 (GPL-3.0-or-later) によるフリーソフトウェアです。いかなる保証もありません。</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>引用方法</translation>
    </message>
    <message>
        <source>Show the whole text of the license, or hide it</source>
        <translation>ライセンスの全文を表示または非表示にします</translation>
    </message>
    <message>
        <source>Copy citation</source>
        <translation>引用をコピー</translation>
    </message>
    <message>
        <source>Copy the line for your list of references</source>
        <translation>参考文献リスト用の行をコピーします</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddPersonTool</name>
    <message>
        <source>Click the person</source>
        <translation>人物をクリック</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter says that a person is there</source>
        <translation>%1 の画像：矢印キーで十字を動かし、Enter でそこに人物がいると伝えます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackgroundImageTaker</name>
    <message>
        <source>“%1” is in this image: where it is now it would be taken for the room. Better show a moment without it.</source>
        <translation>この画像には「%1」が写っています。今の位置では部屋の一部とみなされます。写っていない瞬間を表示するほうがよいでしょう。</translation>
    </message>
    <message>
        <source>Use it all the same</source>
        <translation>それでも使う</translation>
    </message>
    <message>
        <source>The camera was changed meanwhile: the image is kept as %1, but not used.</source>
        <translation>その間にカメラが変更されました。画像は %1 として保存しましたが、使用しません。</translation>
    </message>
    <message>
        <source>Change empty room</source>
        <translation>空の部屋を変更</translation>
    </message>
    <message>
        <source>The image shown is now the empty room of %1; it is kept as %2.</source>
        <translation>表示中の画像を %1 の無人の部屋にしました。%2 に保存されています。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackwardTracker</name>
    <message>
        <source>Correct position</source>
        <translation>位置を修正</translation>
    </message>
    <message>
        <source>The target was followed back to frame %1; from there on it is tracked again.</source>
        <translation>ターゲットをフレーム%1までさかのぼって追跡しました。そこから追跡し直します。</translation>
    </message>
    <message>
        <source>Following the target back in time: frame %1.</source>
        <translation>ターゲットをさかのぼって追跡しています: フレーム%1。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BirdsEyeView</name>
    <message>
        <source>Bird&apos;s-eye view</source>
        <translation>鳥瞰図</translation>
    </message>
    <message>
        <source>The room in 3D: cameras, particles, estimates and their tracks</source>
        <translation>部屋の 3D 表示：カメラ、粒子、推定位置とその軌跡</translation>
    </message>
    <message>
        <source>No 3D: %1</source>
        <translation>3D 表示なし：%1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrationPage</name>
    <message>
        <source>Board</source>
        <translation>ボード</translation>
    </message>
    <message>
        <source>What to find</source>
        <translation>求めるもの</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>キャリブレーション</translation>
    </message>
    <message>
        <source>Look for the board in the recording, and calibrate the cameras with it; one step that can be undone</source>
        <translation>録画からボードを探してカメラをキャリブレーションします。1つの取り消せる手順です</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop; the former calibration is kept</source>
        <translation>中止します。以前のキャリブレーションは保たれます</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Take the calibration into the project; one step that can be undone</source>
        <translation>キャリブレーションをプロジェクトに取り込みます。1つの取り消せる手順です</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>レポート…</translation>
    </message>
    <message>
        <source>Save a page with residuals, coverage and errors of all pictures, and open it</source>
        <translation>残差、カバー範囲、全画像の誤差のページを保存して開きます</translation>
    </message>
    <message>
        <source>How far the calibration is</source>
        <translation>キャリブレーションの進み具合</translation>
    </message>
    <message>
        <source>Show a printed board to the cameras: you are told what to show next, and it is taken when you hold it still.</source>
        <translation>印刷したボードをカメラに見せてください。次に何を見せるかが示され、静止させると取り込まれます。</translation>
    </message>
    <message>
        <source>A recording in which a printed board is shown to the cameras, held still in many places, near and tilted, calibrates them.</source>
        <translation>印刷したボードを多くの場所で、近づけたり傾けたりして静止させながらカメラに見せた録画から、キャリブレーションします。</translation>
    </message>
    <message>
        <source>Live cameras</source>
        <translation>ライブカメラ</translation>
    </message>
    <message>
        <source>This recording</source>
        <translation>この録画</translation>
    </message>
    <message>
        <source>✓ The cameras are calibrated (Ctrl+Z takes it back).</source>
        <translation>✓ カメラをキャリブレーションしました（Ctrl+Zで取り消せます）。</translation>
    </message>
    <message>
        <source>Looking for the board: %p %</source>
        <translation>ボードを探しています: %p %</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>計算中</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>レポートを保存</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>ページ (*.html)</translation>
    </message>
    <message>
        <source>Use it anyway</source>
        <translation>それでも使う</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrator</name>
    <message>
        <source>Stopped: the former calibration is kept.</source>
        <translation>中止しました。以前のキャリブレーションはそのままです。</translation>
    </message>
    <message>
        <source>The project has other cameras by now: calibrate again.</source>
        <translation>プロジェクトのカメラが変わりました。もう一度キャリブレーションしてください。</translation>
    </message>
    <message>
        <source>Calibrate with a board</source>
        <translation>ボードでキャリブレーション</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardForm</name>
    <message>
        <source>Print the board</source>
        <translation>ボードを印刷</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>チェスボード</translation>
    </message>
    <message>
        <source>ChArUco (with markers)</source>
        <translation>ChArUco（マーカー付き）</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>ボードの種類</translation>
    </message>
    <message>
        <source>ChArUco boards may be partly hidden or outside the image; chessboards must be seen whole</source>
        <translation>ChArUcoボードは一部が隠れても画像の外に出てもかまいません。チェスボードは全体が見える必要があります</translation>
    </message>
    <message>
        <source>Squares across, down</source>
        <translation>マス目の数（横・縦）</translation>
    </message>
    <message>
        <source>Squares in a row</source>
        <translation>横のマス目の数</translation>
    </message>
    <message>
        <source>All squares of a row, black and white</source>
        <translation>1行のすべてのマス目（黒と白）</translation>
    </message>
    <message>
        <source>Squares in a column</source>
        <translation>縦のマス目の数</translation>
    </message>
    <message>
        <source>All squares of a column, black and white</source>
        <translation>1列のすべてのマス目（黒と白）</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>マス目の一辺</translation>
    </message>
    <message>
        <source>Measured on the print: a long row with a ruler, divided by its squares</source>
        <translation>印刷物で測ります。長い行を定規で測り、マス目の数で割ります</translation>
    </message>
    <message>
        <source>Unit of the sizes</source>
        <translation>寸法の単位</translation>
    </message>
    <message>
        <source>Unit in which the sizes are typed</source>
        <translation>寸法を入力する単位</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>マーカーの一辺</translation>
    </message>
    <message>
        <source>Of the black square around the pattern</source>
        <translation>模様を囲む黒い四角の一辺</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>マーカーの辞書</translation>
    </message>
    <message>
        <source>As the program called it that made it</source>
        <translation>ボードを作ったプログラムでの名前</translation>
    </message>
    <message>
        <source>Even rows of older software</source>
        <translation>古いソフトウェアの偶数行</translation>
    </message>
    <message>
        <source>A ChArUco board with an even number of rows from software older than OpenCV 4.6: its first square is white</source>
        <translation>OpenCV 4.6より古いソフトウェアで作った偶数行のChArUcoボード（最初のマス目が白）</translation>
    </message>
    <message>
        <source>Black and white exchanged</source>
        <translation>白黒反転</translation>
    </message>
    <message>
        <source>White markers and corners on a black page</source>
        <translation>黒い紙に白いマーカーと角</translation>
    </message>
    <message>
        <source>Print this board…</source>
        <translation>このボードを印刷…</translation>
    </message>
    <message>
        <source>Write the board as a PDF in its true size, with a bar to check it with a ruler</source>
        <translation>ボードを実寸のPDFに書き出します。定規で確かめる目盛りが付きます</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>Size of the sheet that is printed on</source>
        <translation>印刷する用紙の大きさ</translation>
    </message>
    <message>
        <source>%1 × %2 inner corners; for the command line:</source>
        <translation>内側の角 %1 × %2。コマンドライン用:</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>辞書</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardGoalForm</name>
    <message>
        <source>Find</source>
        <translation>求めるもの</translation>
    </message>
    <message>
        <source>Lenses and places</source>
        <translation>レンズと位置</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>レンズ</translation>
    </message>
    <message>
        <source>Places of the cameras</source>
        <translation>カメラの位置</translation>
    </message>
    <message>
        <source>What is found</source>
        <translation>求めるもの</translation>
    </message>
    <message>
        <source>Lenses: how each camera sees, by itself. Places: where the cameras stand, from a board that several of them see at once</source>
        <translation>レンズ: 各カメラの写り方。位置: 複数のカメラが同時に見るボードから求めるカメラの場所</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>レンズモデル</translation>
    </message>
    <message>
        <source>Pinhole, 5 coefficients</source>
        <translation>ピンホール、係数5個</translation>
    </message>
    <message>
        <source>Pinhole, 8 coefficients (wide)</source>
        <translation>ピンホール、係数8個（広角）</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>魚眼</translation>
    </message>
    <message>
        <source>5 for most lenses; 8 for wide ones; fisheye from about 120° on</source>
        <translation>ほとんどのレンズは5、広角は8、約120°以上は魚眼</translation>
    </message>
    <message>
        <source>The board lies on the floor in frame</source>
        <translation>ボードが床に置かれているフレーム</translation>
    </message>
    <message>
        <source>That frame makes the world: X along the rows, Y to the upper edge, Z up. Without it the first camera keeps its place</source>
        <translation>このフレームが世界座標を決めます。Xは行の向き、Yは上の辺の向き、Zは上。指定しなければ最初のカメラの位置を保ちます</translation>
    </message>
    <message>
        <source>Frame in which the board lies on the floor</source>
        <translation>ボードが床にあるフレーム</translation>
    </message>
    <message>
        <source>Number of the frame</source>
        <translation>フレーム番号</translation>
    </message>
    <message>
        <source>This one</source>
        <translation>このフレーム</translation>
    </message>
    <message>
        <source>The frame shown</source>
        <translation>表示中のフレーム</translation>
    </message>
    <message>
        <source>Take the frame that is shown now</source>
        <translation>今表示しているフレームを使います</translation>
    </message>
    <message>
        <source>Enough at</source>
        <translation>目標精度</translation>
    </message>
    <message>
        <source>Accuracy wanted of lenses</source>
        <translation>レンズの目標精度</translation>
    </message>
    <message>
        <source>The guidance ends when a ray is known to so many pixels all over the image</source>
        <translation>画像全体で光線がこのピクセル数まで分かると案内が終わります</translation>
    </message>
    <message>
        <source>Accuracy wanted of places</source>
        <translation>位置の目標精度</translation>
    </message>
    <message>
        <source>The guidance ends when the place of each camera is known so well</source>
        <translation>各カメラの位置がこの精度で分かると案内が終わります</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardLive</name>
    <message>
        <source>How long the board was held still before %1</source>
        <translation>%1の前でボードを静止させた時間</translation>
    </message>
    <message>
        <source>Where %1 saw the board</source>
        <translation>%1がボードを見た場所</translation>
    </message>
    <message>
        <source>Filled: the regions and tilts that the board was shown in. Orange: what is asked for. Green: the board as it is seen now</source>
        <translation>塗り: ボードを見せた領域と傾き。オレンジ: 次に求められるもの。緑: 今見えているボード</translation>
    </message>
    <message>
        <source>Capture now</source>
        <translation>今取り込む</translation>
    </message>
    <message>
        <source>Take the board as it is shown now, also when it is not held still</source>
        <translation>静止していなくても、今見せているボードを取り込みます</translation>
    </message>
    <message>
        <source>On the floor now</source>
        <translation>今、床にある</translation>
    </message>
    <message>
        <source>Take the board as it lies on the floor now: it makes the world. X along its rows, Y to its upper edge, Z up</source>
        <translation>今床にあるボードを取り込み、世界座標を決めます。Xは行の向き、Yは上の辺の向き、Zは上</translation>
    </message>
    <message>
        <source>Next: places</source>
        <translation>次へ: 位置</translation>
    </message>
    <message>
        <source>Leave the lenses as well known as they are, and show the board to several cameras at once</source>
        <translation>レンズは今の精度のままにして、ボードを複数のカメラに同時に見せます</translation>
    </message>
    <message>
        <source>Calibrate with these views</source>
        <translation>これらのビューでキャリブレーション</translation>
    </message>
    <message>
        <source>End here: what was taken so far is enough</source>
        <translation>ここで終わります。これまでの取り込みで十分です</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Look for the board in the live images, and be told what to show</source>
        <translation>ライブ画像でボードを探し、何を見せるかを案内します</translation>
    </message>
    <message>
        <source>Waiting for images: are the cameras playing?</source>
        <translation>画像を待っています。カメラは再生中ですか？</translation>
    </message>
    <message>
        <source>Show the board to one camera after the other, as each of them asks.</source>
        <translation>各カメラの案内に従って、順番にボードを見せてください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxExportDialog</name>
    <message>
        <source>Export boxes</source>
        <translation>枠を書き出す</translation>
    </message>
    <message>
        <source>Two files are written: boxes.csv (a row per target and frame: box, center, similarity, seen or hidden) and boxes_mot.txt (the format of the MOT challenge). All in pixels.</source>
        <translation>2 つのファイルを書き出します。boxes.csv（目標とフレームごとに 1 行：枠、中心、類似度、見えているか隠れているか）と boxes_mot.txt（MOT Challenge の形式）。単位はすべてピクセルです。</translation>
    </message>
    <message>
        <source>How boxes.csv begins</source>
        <translation>boxes.csv の冒頭</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Both files go there; it is made if need be</source>
        <translation>両方のファイルの保存先。なければ作られます</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the folder of the files</source>
        <translation>ファイルのフォルダーを選ぶ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Write both files (Enter)</source>
        <translation>両方のファイルを書き出す（Enter）</translation>
    </message>
    <message>
        <source>Folder of the boxes</source>
        <translation>枠のフォルダー</translation>
    </message>
    <message>
        <source>boxes.csv and boxes_mot.txt are in %1.</source>
        <translation>boxes.csv と boxes_mot.txt は %1 にあります。</translation>
    </message>
    <message>
        <source>The boxes of another export are there already. Replace them?</source>
        <translation>別の書き出しの枠がすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 はすでに存在するため、何も書き込みませんでした。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxModel</name>
    <message>
        <source>● held</source>
        <translation>● 追跡中</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ 隠れている</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>時間, s</translation>
    </message>
    <message>
        <source>Seconds, of the frame</source>
        <translation>フレームの時刻（秒）</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>1 から数えたフレーム番号</translation>
    </message>
    <message>
        <source>target</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>対象の名前</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the left edge of the image</source>
        <translation>枠の中心、画像の左端からのピクセル数</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the upper edge of the image</source>
        <translation>枠の中心、画像の上端からのピクセル数</translation>
    </message>
    <message>
        <source>width, px</source>
        <translation>幅, px</translation>
    </message>
    <message>
        <source>Width of the box, pixels</source>
        <translation>枠の幅、ピクセル</translation>
    </message>
    <message>
        <source>height, px</source>
        <translation>高さ, px</translation>
    </message>
    <message>
        <source>Height of the box, pixels</source>
        <translation>枠の高さ、ピクセル</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>類似度</translation>
    </message>
    <message>
        <source>How alike the colors in the box are to those it was given with, 0 to 1</source>
        <translation>枠の中の色が、与えられたときの色にどれだけ似ているか（0〜1）</translation>
    </message>
    <message>
        <source>spread, px</source>
        <translation>広がり, px</translation>
    </message>
    <message>
        <source>Root mean square distance of the particles to their mean</source>
        <translation>粒子とその平均との距離の二乗平均平方根</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Hidden: it is held where it is thought to be</source>
        <translation>隠れている：あると思われる場所に保たれます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message>
        <source>Boxes of the targets</source>
        <translation>目標の枠</translation>
    </message>
    <message>
        <source>This method follows boxes in images: click the thing or drag a box around it in any camera view. Its box in every frame appears here, in pixels.</source>
        <translation>この手法は画像の中の枠を追います。どれかのカメラ画像で物をクリックするか、囲むようにドラッグしてください。各フレームでの枠がピクセル単位でここに表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n boxes, in pixels of the image</source>
        <translation>
            <numerusform>%n 個の枠（画像のピクセル単位）</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPicker</name>
    <message>
        <source>This camera shows no image to take a box from.</source>
        <translation>このカメラには、枠を取る画像が表示されていません。</translation>
    </message>
    <message>
        <source>Box of %1</source>
        <translation>%1 の枠</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationChoice</name>
    <message>
        <source>Calibration:</source>
        <translation>キャリブレーション:</translation>
    </message>
    <message>
        <source>Choose calibration…</source>
        <translation>キャリブレーションを選択…</translation>
    </message>
    <message>
        <source>A calibration file of Dewpoint or another program; cameras are found by their names, or else taken in its order</source>
        <translation>Dewpoint または他のプログラムのキャリブレーションファイル。カメラは名前で対応づけ、できなければファイル内の順番で対応づけます</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Go without a calibration file</source>
        <translation>キャリブレーションファイルを使いません</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>キャリブレーションを選択</translation>
    </message>
    <message>
        <source>Recognized: %1. It leaves something open: %2. Create the project without it; then Import calibration asks for what is missing.</source>
        <translation>判別: %1。決まっていないことがあります: %2。これなしでプロジェクトを作成してください。その後「較正をインポート」で足りないものを指定できます。</translation>
    </message>
    <message>
        <source>Recognized: %1. It cannot be used: %2.</source>
        <translation>判別: %1。使用できません: %2。</translation>
    </message>
    <message>
        <source>The file cannot be used: %1.</source>
        <translation>このファイルは使用できません: %1。</translation>
    </message>
    <message>
        <source>Not recognized. Dewpoint reads: %1.</source>
        <translation>判別できません。Dewpoint が読める形式: %1。</translation>
    </message>
    <message>
        <source>Recognized: %1. Its cameras do not fit those above: %2.</source>
        <translation>判別: %1。カメラが上のものと合いません: %2。</translation>
    </message>
    <message numerus="yes">
        <source>✓ Recognized: %1, %n cameras</source>
        <translation>
            <numerusform>✓ 判別: %1、カメラ %n 台</numerusform>
        </translation>
    </message>
    <message>
        <source>None: camera positions will be a guess</source>
        <translation>なし: カメラ位置は推測になります</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読み込み中…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationDock</name>
    <message>
        <source>Ways to calibrate</source>
        <translation>校正の方法</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationExportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選択</translation>
    </message>
    <message>
        <source>Export the calibration</source>
        <translation>較正をエクスポート</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Write the file; one that exists is replaced</source>
        <translation>ファイルを書き出す。既存のものは置き換えられます</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>The program that is to read the file</source>
        <translation>ファイルを読むプログラム</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Of lengths, where the format leaves it open</source>
        <translation>長さの単位。形式が定めていない場合</translation>
    </message>
    <message>
        <source>as usual for the format</source>
        <translation>形式の通例どおり</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>%1: largest reprojection difference %2 (fitted anew)</source>
        <translation>%1: 再投影の最大差 %2（当てはめ直し）</translation>
    </message>
    <message>
        <source>%1: largest reprojection difference %2</source>
        <translation>%1: 再投影の最大差 %2</translation>
    </message>
    <message>
        <source>%1: %2 of 81 directions have no pixel any more</source>
        <translation>%1: 81方向のうち %2 方向に画素がなくなりました</translation>
    </message>
    <message>
        <source>%1 exists and will be replaced.</source>
        <translation>%1 は既にあり、置き換えられます。</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationImportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選択</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>較正をインポート</translation>
    </message>
    <message>
        <source>as the names say</source>
        <translation>名前のとおり</translation>
    </message>
    <message>
        <source>only %1</source>
        <translation>%1 だけ</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダー…</translation>
    </message>
    <message>
        <source>Find a folder with a file for each camera</source>
        <translation>カメラごとのファイルがあるフォルダーを探す</translation>
    </message>
    <message>
        <source>Use these cameras</source>
        <translation>このカメラを使う</translation>
    </message>
    <message>
        <source>Take the calibration into the project; it can be undone</source>
        <translation>較正をプロジェクトに取り込む。元に戻せます</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>ファイルのとおり</translation>
    </message>
    <message>
        <source>recognized from the content</source>
        <translation>内容から判別</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source>k1 k2 p1 p2 of a pinhole</source>
        <translation>ピンホールの k1 k2 p1 p2</translation>
    </message>
    <message>
        <source>k1 k2 k3 k4 of a fisheye</source>
        <translation>魚眼の k1 k2 k3 k4</translation>
    </message>
    <message>
        <source>as the format has them</source>
        <translation>形式のとおり</translation>
    </message>
    <message>
        <source>camera from world</source>
        <translation>世界からカメラへ</translation>
    </message>
    <message>
        <source>world from camera</source>
        <translation>カメラから世界へ</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>The program that wrote the file</source>
        <translation>ファイルを書いたプログラム</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Of lengths in the file; or type the meters of one unit, such as 0.025 for squares of 25 mm</source>
        <translation>ファイル内の長さの単位。または1単位のメートル数を入力（25 mm のマス目なら 0.025）</translation>
    </message>
    <message>
        <source>Four coefficients</source>
        <translation>4つの係数</translation>
    </message>
    <message>
        <source>What four lens coefficients mean</source>
        <translation>4つのレンズ係数の意味</translation>
    </message>
    <message>
        <source>Size of images</source>
        <translation>画像の大きさ</translation>
    </message>
    <message>
        <source>Width and height in pixels, such as 1280x720</source>
        <translation>幅と高さ（ピクセル）。例 1280x720</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Which way the poses in the file go</source>
        <translation>ファイル内の姿勢の向き</translation>
    </message>
    <message>
        <source>For</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Which camera a file of one camera is about</source>
        <translation>1台分のファイルがどのカメラのものか</translation>
    </message>
    <message>
        <source>The file leaves something open. Answer “%1” above.</source>
        <translation>ファイルだけでは決まりません。上の「%1」に答えてください。</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>キャリブレーションのカメラ名が異なるため、順番で対応づけました。</translation>
    </message>
    <message>
        <source>There is no pose in the file: only the lens is taken, the pose stays.</source>
        <translation>ファイルに姿勢がありません。レンズだけを取り込み、姿勢はそのままです。</translation>
    </message>
    <message>
        <source>%1 (in the file: %2): %3 and %4 from where it is now</source>
        <translation>%1（ファイルでは %2）: 今の位置から %3、%4</translation>
    </message>
    <message>
        <source>Largest reprojection difference to the file: %1</source>
        <translation>ファイルとの再投影の最大差: %1</translation>
    </message>
    <message>
        <source>Import calibration</source>
        <translation>較正をインポート</translation>
    </message>
    <message>
        <source>The cameras have the calibration of %1 now.</source>
        <translation>カメラは %1 のキャリブレーションを使います。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationMode</name>
    <message>
        <source>Calibration</source>
        <translation>校正</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraAgreementAlerts</name>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 を校正…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraForm</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>The camera that is adjusted; clicking into its image chooses it too</source>
        <translation>調整するカメラ。画像をクリックしても選べます</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>Unit of positions</source>
        <translation>位置の単位</translation>
    </message>
    <message>
        <source>Unit in which positions are shown and typed</source>
        <translation>位置の表示と入力に使う単位</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>視線</translation>
    </message>
    <message>
        <source>at a point, roll</source>
        <translation>注視点とロール</translation>
    </message>
    <message>
        <source>yaw, pitch, roll</source>
        <translation>ヨー、ピッチ、ロール</translation>
    </message>
    <message>
        <source>How the direction is said</source>
        <translation>向きの表し方</translation>
    </message>
    <message>
        <source>A point that the camera looks at, or angles: yaw from x toward y, pitch above the horizon, roll about the line of sight</source>
        <translation>カメラの注視点、または角度: ヨーは x から y へ、ピッチは水平より上、ロールは視線まわり</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>レンズ</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>焦点距離</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>画角</translation>
    </message>
    <message>
        <source>How the lens is said</source>
        <translation>レンズの表し方</translation>
    </message>
    <message>
        <source>Focal length in pixels, or the horizontal field of view in degrees</source>
        <translation>焦点距離(ピクセル)または水平画角(度)</translation>
    </message>
    <message>
        <source>Focal length or field of view</source>
        <translation>焦点距離または画角</translation>
    </message>
    <message>
        <source>How much the camera magnifies; the keys + and − change it too</source>
        <translation>カメラの倍率。+ と − のキーでも変わります</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>ドラッグ</translation>
    </message>
    <message>
        <source>turns the camera</source>
        <translation>カメラを回す</translation>
    </message>
    <message>
        <source>slides the camera</source>
        <translation>カメラをずらす</translation>
    </message>
    <message>
        <source>What dragging does</source>
        <translation>ドラッグの働き</translation>
    </message>
    <message>
        <source>What the camera does while the grid is dragged and nothing is held. Click points of the grid to hold up to three of them.</source>
        <translation>何も固定せずに格子をドラッグしたときのカメラの動き。格子の点をクリックすると三つまで固定できます。</translation>
    </message>
    <message>
        <source>Three held points: the focal length gives way</source>
        <translation>三点固定時は焦点距離が変わる</translation>
    </message>
    <message>
        <source>Three held points fix the pose; dragging then changes the focal length, and the camera follows</source>
        <translation>三点を固定すると姿勢が決まります。ドラッグは焦点距離を変え、カメラがそれに従います</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>What keys do</source>
        <translation>キーの働き</translation>
    </message>
    <message>
        <source>Arrows or W A S D, with Q and E or the page keys: 1 cm or 0.2° a step. Shift: ten times as much; Ctrl with arrows and page keys: a tenth.</source>
        <translation>矢印または W A S D と Q、E または PageUp/PageDown: 一回 1 cm または 0.2°。Shift: 十倍。Ctrl と矢印・Page キー: 十分の一。</translation>
    </message>
    <message>
        <source>as it looks</source>
        <translation>カメラの向きに沿って</translation>
    </message>
    <message>
        <source>along x, y, z</source>
        <translation>x、y、z に沿って</translation>
    </message>
    <message>
        <source>Directions of keys</source>
        <translation>キーの方向</translation>
    </message>
    <message>
        <source>Right, forward and up as the camera looks, or the axes of the world</source>
        <translation>カメラから見た右・前・上、または世界の軸</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>ヨー</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>ピッチ</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>位置 %1</translation>
    </message>
    <message>
        <source>Where the camera stands, along %1</source>
        <translation>カメラの位置の %1 座標</translation>
    </message>
    <message>
        <source>Looks at %1</source>
        <translation>注視点 %1</translation>
    </message>
    <message>
        <source>The point the camera looks at, along %1</source>
        <translation>カメラの注視点の %1 座標</translation>
    </message>
    <message>
        <source>Direction from above: 0° along x, 90° along y</source>
        <translation>上から見た向き: x 方向が 0°、y 方向が 90°</translation>
    </message>
    <message>
        <source>Above the horizon; straight down is −90°</source>
        <translation>水平より上の角度。真下は −90°</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>ロール</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>ロール</translation>
    </message>
    <message>
        <source>Turned about its line of sight, clockwise</source>
        <translation>視線まわりの時計回りの回転</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>looks at</source>
        <translation>注視点</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>ヨー</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>ピッチ</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraMotionAlerts</name>
    <message>
        <source>%1 was %2 (frame %3).</source>
        <translation>%1 が %2 しました（フレーム %3）。</translation>
    </message>
    <message>
        <source>Its new pose is being worked out.</source>
        <translation>新しい姿勢を計算しています。</translation>
    </message>
    <message>
        <source>Its pose can be solved again from what it sees.</source>
        <translation>見えているものから姿勢を解き直せます。</translation>
    </message>
    <message>
        <source>Re-solve %1</source>
        <translation>%1 を解き直す</translation>
    </message>
    <message>
        <source>It cannot be solved again from what it sees: calibrate it anew, or put it back.</source>
        <translation>見えているものからは解き直せません。再校正するか、元に戻してください。</translation>
    </message>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 を校正…</translation>
    </message>
    <message>
        <source>%1 stands again as it was calibrated.</source>
        <translation>%1 は校正時の位置に戻りました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraPanel</name>
    <message>
        <source>Rename camera</source>
        <translation>カメラの名前を変更</translation>
    </message>
    <message>
        <source>Change source of images</source>
        <translation>画像の元を変更</translation>
    </message>
    <message>
        <source>Turn images</source>
        <translation>画像を回転</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>キャリブレーションを選択</translation>
    </message>
    <message>
        <source>Calibrations (*.toml);;All files (*)</source>
        <translation>キャリブレーション (*.toml);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>表示やファイルで使うカメラの名前</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Video file, folder of images, device or address of a stream</source>
        <translation>動画ファイル、画像フォルダー、デバイス、または映像のアドレス</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Find the recording of this camera in another place</source>
        <translation>このカメラの録画を別の場所から選びます</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Images are turned clockwise by so much before use</source>
        <translation>画像は使う前に時計回りにこれだけ回転されます</translation>
    </message>
    <message>
        <source>Load calibration…</source>
        <translation>キャリブレーションを読み込む…</translation>
    </message>
    <message>
        <source>Take the calibration of all cameras from a file</source>
        <translation>すべてのカメラのキャリブレーションをファイルから読み込みます</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, focal length %3 pixels
at %4, %5, %6</source>
        <translation>%1 × %2 ピクセル、焦点距離 %3 ピクセル
位置 %4, %5, %6</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>画像フォルダーを選択</translation>
    </message>
    <message>
        <source>Choose the video of this camera</source>
        <translation>このカメラの動画を選択</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>画像を反転</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Images are mirrored left to right, after they were turned</source>
        <translation>回転したあと、画像を左右に反転します</translation>
    </message>
    <message>
        <source>Empty room</source>
        <translation>空の部屋</translation>
    </message>
    <message>
        <source>Image, video or folder of images in which this camera shows the scene without any target: what has its color there is not taken for it</source>
        <translation>このカメラがターゲットのない場面を写した画像、動画、または画像のフォルダー。そこで同じ色だったものはターゲットとみなしません</translation>
    </message>
    <message>
        <source>Choose the empty room</source>
        <translation>空の部屋を選択</translation>
    </message>
    <message>
        <source>Find an image or a video of the scene without any target</source>
        <translation>ターゲットのない場面の画像か動画を探します</translation>
    </message>
    <message>
        <source>Use the image shown</source>
        <translation>表示中の画像を使う</translation>
    </message>
    <message>
        <source>Keep the image this camera shows now as the one of the empty room</source>
        <translation>このカメラが今表示している画像を空の部屋の画像として保存します</translation>
    </message>
    <message>
        <source>Change empty room</source>
        <translation>空の部屋を変更</translation>
    </message>
    <message>
        <source>Choose an image or a video of the empty room</source>
        <translation>空の部屋の画像か動画を選択</translation>
    </message>
    <message>
        <source>Change how late the images are</source>
        <translation>画像の遅れの変更</translation>
    </message>
    <message>
        <source>Late by</source>
        <translation>遅れ</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Milliseconds by which its images are late: they are put together with those of the other cameras by it. Calibrate by waving finds it</source>
        <translation>この画像が遅れているミリ秒数。これを使って他のカメラの画像と組み合わせます。「振って較正」で求められます</translation>
    </message>
    <message>
        <source>Milliseconds by which the images are late</source>
        <translation>画像が遅れているミリ秒数</translation>
    </message>
    <message>
        <source>Load calibration</source>
        <translation>キャリブレーションを読み込む</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>キャリブレーションのカメラ名が異なるため、順番で対応づけました。</translation>
    </message>
    <message>
        <source>The cameras have the calibration of %1 now.</source>
        <translation>カメラは %1 のキャリブレーションを使います。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraTable</name>
    <message>
        <source>rtsp://192.168.0.10/stream, or a device number such as 0</source>
        <translation>rtsp://192.168.0.10/stream、または 0 などのデバイス番号</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読み込み中…</translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %3 frames per second · %n frames</source>
        <translation>
            <numerusform>✓ %1×%2 · 毎秒 %3 フレーム · %n フレーム</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %n images</source>
        <translation>
            <numerusform>✓ %1×%2 · 画像 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Live: tried when the project is made</source>
        <translation>ライブ: プロジェクトの作成時に接続を試します</translation>
    </message>
    <message>
        <source>Videos differ in frame rate: frame N of one is not the same moment as frame N of the other.</source>
        <translation>動画のフレームレートが異なります: 一方のフレーム N と他方のフレーム N は同じ時点ではありません。</translation>
    </message>
    <message numerus="yes">
        <source>Videos differ in length: using the first %n frames.</source>
        <translation>
            <numerusform>動画の長さが異なります: 最初の %n フレームを使います。</numerusform>
        </translation>
    </message>
    <message>
        <source>Videos differ in size: each camera keeps its own.</source>
        <translation>動画の大きさが異なります: 各カメラはそれぞれの大きさのままです。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraView</name>
    <message>
        <source>This camera delivered no image for this frame.</source>
        <translation>このフレームではカメラから画像が届きませんでした。</translation>
    </message>
    <message>
        <source>No images yet. Press play (Space), or open a project (Ctrl+O).</source>
        <translation>まだ画像がありません。再生する（スペース）か、プロジェクトを開いてください（Ctrl+O）。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ChangesGuard</name>
    <message>
        <source>Save the project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml)</source>
        <translation>Dewpoint プロジェクト (*.toml)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>保存されていない変更</translation>
    </message>
    <message>
        <source>Save the changes to this project?</source>
        <translation>このプロジェクトの変更を保存しますか？</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorChoice</name>
    <message>
        <source>Color %1</source>
        <translation>色 %1</translation>
    </message>
    <message>
        <source>Show this color, so that its range can be changed by hand</source>
        <translation>ターゲットのこの色を表示し、範囲を手で変えられるようにする</translation>
    </message>
    <message>
        <source>Colors of the target</source>
        <translation>ターゲットの色</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Remove this color from the target, and the samples that show it</source>
        <translation>この色を、それを示す見本とともにターゲットから外す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorDock</name>
    <message>
        <source>Color</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Take a box here</source>
        <translation>ここで枠を取る</translation>
    </message>
    <message>
        <source>Learn the color here</source>
        <translation>ここの色を学習</translation>
    </message>
    <message>
        <source>Add a sample here</source>
        <translation>ここの見本を追加</translation>
    </message>
    <message>
        <source>This is not the target</source>
        <translation>これはターゲットではありません</translation>
    </message>
    <message>
        <source>Track this object, starting from a box around it</source>
        <translation>この物体を、それを囲む枠から追跡します</translation>
    </message>
    <message>
        <source>Learn the target&apos;s color from this spot</source>
        <translation>この位置でターゲットの色を学習します</translation>
    </message>
    <message>
        <source>Add this color to the target&apos;s (Shift-click does the same)</source>
        <translation>この色をターゲットの色に加えます（Shift クリックでも可）</translation>
    </message>
    <message>
        <source>Exclude this color (Alt-click does the same)</source>
        <translation>この色を除外します（Alt クリックでも可）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLearner</name>
    <message>
        <source>This camera shows no image to learn from.</source>
        <translation>このカメラには学習に使える画像がありません。</translation>
    </message>
    <message>
        <source>Click the target first; then exclude what is not it.</source>
        <translation>まずターゲットをクリックし、その後で違うものを除外してください。</translation>
    </message>
    <message>
        <source>Exclude color</source>
        <translation>色を除外</translation>
    </message>
    <message>
        <source>Add color sample</source>
        <translation>色見本を追加</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>色を学習</translation>
    </message>
    <message>
        <source>Remove color sample</source>
        <translation>色見本を取り除く</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPanel</name>
    <message>
        <source>Looking at the images…</source>
        <translation>画像を調べています…</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>ターゲットなし</translation>
    </message>
    <message>
        <source>A new target</source>
        <translation>新しいターゲット</translation>
    </message>
    <message>
        <source>Drag ring and bars, or press Learn and click the target.</source>
        <translation>リングやバーをドラッグするか、「学習」を押してターゲットをクリックしてください。</translation>
    </message>
    <message>
        <source>Click the thing to follow in any camera image.</source>
        <translation>カメラ画像で追跡したいものをクリックしてください。</translation>
    </message>
    <message>
        <source>Change color range</source>
        <translation>色の範囲を変更</translation>
    </message>
    <message>
        <source>Click the thing to follow</source>
        <translation>追跡したいものをクリック</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it</source>
        <translation>物をクリックするか、囲むようにドラッグ</translation>
    </message>
    <message>
        <source>Followed from its box in %1, frame %2: %3 × %4. This method needs no color; press Box and click the thing for another box.</source>
        <translation>%1 のフレーム %2 の枠（%3 × %4）から追跡しています。この手法に色は要りません。別の枠にするには「枠」を押して物をクリックします。</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>どれかのカメラ画像で、物をクリックするか、囲むようにドラッグしてください。</translation>
    </message>
    <message>
        <source>Remove color</source>
        <translation>色を外す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPicker</name>
    <message>
        <source>H&amp;ue</source>
        <translation>色相(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Saturation</source>
        <translation>彩度(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Intensity</source>
        <translation>輝度(&amp;I)</translation>
    </message>
    <message>
        <source>First hue, 0 to 360 degrees; above the last hue the range goes through red</source>
        <translation>最初の色相（0〜360度）。最後の色相より大きいと赤をまたぎます</translation>
    </message>
    <message>
        <source>Last hue, 0 to 360 degrees</source>
        <translation>最後の色相（0〜360度）</translation>
    </message>
    <message>
        <source>Least saturation, 0 to 1</source>
        <translation>最小の彩度（0〜1）</translation>
    </message>
    <message>
        <source>Greatest saturation, 0 to 1</source>
        <translation>最大の彩度（0〜1）</translation>
    </message>
    <message>
        <source>Least intensity, 0 to 1</source>
        <translation>最小の輝度（0〜1）</translation>
    </message>
    <message>
        <source>Greatest intensity, 0 to 1</source>
        <translation>最大の輝度（0〜1）</translation>
    </message>
    <message>
        <source>Drag the ends or the middle; with the keyboard, Tab chooses and the arrows move (with Shift ten times as far)</source>
        <translation>両端または中央をドラッグします。キーボードでは Tab で選び、矢印で動かします（Shift で10倍）</translation>
    </message>
    <message>
        <source>Range of hues</source>
        <translation>色相の範囲</translation>
    </message>
    <message>
        <source>Range of saturation</source>
        <translation>彩度の範囲</translation>
    </message>
    <message>
        <source>Range of intensity</source>
        <translation>輝度の範囲</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorSampleList</name>
    <message>
        <source>Learned from</source>
        <translation>学習に使った見本</translation>
    </message>
    <message>
        <source>Samples the color was learned from</source>
        <translation>色の学習に使った見本</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>not this: %1, frame %2, at %3, %4</source>
        <translation>除外: %1、フレーム %2、位置 %3, %4</translation>
    </message>
    <message>
        <source>%1, frame %2, at %3, %4</source>
        <translation>%1、フレーム %2、位置 %3, %4</translation>
    </message>
    <message>
        <source>found: %1, frame %2, at %3, %4</source>
        <translation>検出: %1、フレーム %2、位置 %3, %4</translation>
    </message>
    <message>
        <source>Shift-click in an image adds one, Alt-click or Ctrl+Shift-click excludes one. Samples marked “found” were not clicked, but found in other cameras.</source>
        <translation>画像を Shift+クリックするとサンプルを追加し、Alt+クリックまたは Ctrl+Shift+クリックすると除外します。「検出」と表示されたサンプルは、クリックしたものではなく、他のカメラで見つかったものです。</translation>
    </message>
    <message>
        <source>Forget the chosen sample and learn from the rest (Del). A found sample becomes an excluded one.</source>
        <translation>選択したサンプルを破棄し、残りから学習します (Del)。検出されたサンプルは除外サンプルになります。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>何をしますか？</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>操作を検索</translation>
    </message>
    <message>
        <source>Actions found</source>
        <translation>見つかった操作</translation>
    </message>
    <message>
        <source>Nothing here is called “%1”.</source>
        <translation>「%1」という名前のものはありません。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionMode</name>
    <message>
        <source>Drag the target in an image to where it is; the same in another image fixes its depth. Esc ends it.</source>
        <translation>画像の中でターゲットを実際の位置へドラッグします。別の画像でも行うと奥行きが決まります。Esc で終了します。</translation>
    </message>
    <message>
        <source>Correct position</source>
        <translation>位置を修正</translation>
    </message>
    <message>
        <source>There is no correction in this frame.</source>
        <translation>このフレームに修正はありません。</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>修正を取り消す</translation>
    </message>
    <message>
        <source>Say that the target is here in the frame shown: tracking goes on from there</source>
        <translation>表示中のフレームで、ターゲットがここにあると指定します。そこから追跡を続けます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionTool</name>
    <message>
        <source>Drag the target to where it is</source>
        <translation>ターゲットを実際の位置へドラッグしてください</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter says that the target is there</source>
        <translation>%1 の画像：矢印キーで十字を動かし、Enter でターゲットの位置を指定します</translation>
    </message>
    <message>
        <source>Frames are being tracked again: wait until that is done, or pause.</source>
        <translation>フレームを再追跡しています。終わるまで待つか、一時停止してください。</translation>
    </message>
    <message>
        <source>There is no target yet: learn its color first.</source>
        <translation>ターゲットがまだありません。先にその色を学習してください。</translation>
    </message>
    <message>
        <source>Drag an estimate, or select the target in the list first.</source>
        <translation>推定位置をドラッグするか、先に一覧でターゲットを選んでください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CoverageMap</name>
    <message>
        <source>%1: seen %2 times, in %3 of %4 regions of the image</source>
        <translation>%1: %2 回、画像の %4 区画のうち %3 区画で検出</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DockTitle</name>
    <message>
        <source>Float this view, or put it back (double click the title: whole window)</source>
        <translation>この表示を切り離す、または戻す（タイトルをダブルクリック：ウィンドウ全体）</translation>
    </message>
    <message>
        <source>Show all views</source>
        <translation>すべてのビューを表示</translation>
    </message>
    <message>
        <source>Give the other views their places back (Esc, or double click here)</source>
        <translation>ほかのビューを元の場所に戻します（Esc、またはここをダブルクリック）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Document</name>
    <message>
        <source>Change “%1”</source>
        <translation>「%1」を変更</translation>
    </message>
    <message>
        <source>Track by “%1”</source>
        <translation>「%1」で追跡</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>「%1」を既定値に戻す</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>すべてのパラメーターを既定値に戻す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DropZone</name>
    <message>
        <source>Drop videos here, or add them</source>
        <translation>動画をここにドロップするか、追加してください</translation>
    </message>
    <message>
        <source>One per camera; also folders of images, and a calibration file</source>
        <translation>カメラごとに1つ。画像フォルダーやキャリブレーションファイルも使えます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExchangeDialog</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>The file, or the folder with a file for each camera</source>
        <translation>ファイル、またはカメラごとのファイルがあるフォルダー</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>ファイルを選択</translation>
    </message>
    <message>
        <source>Find the file</source>
        <translation>ファイルを探す</translation>
    </message>
    <message>
        <source>What is decided</source>
        <translation>決定内容</translation>
    </message>
    <message>
        <source>Choose a file. What is decided about it is shown here before anything changes.</source>
        <translation>ファイルを選択してください。変更の前に、決定内容がここに表示されます。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>何も変更しない</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExperimentDialog</name>
    <message>
        <source>Canceled.</source>
        <translation>中止しました。</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>Number of seeds. More seeds take longer and give more certain results.</source>
        <translation>シードの数。多いほど時間がかかり、確かになります</translation>
    </message>
    <message>
        <source>The report, its pictures and its numbers go there</source>
        <translation>レポート、図、数値がここに入ります</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the folder of the report</source>
        <translation>レポートのフォルダーを選びます</translation>
    </message>
    <message>
        <source>How far the experiment is</source>
        <translation>実験の進み具合</translation>
    </message>
    <message>
        <source>Run the chosen experiment (Enter)</source>
        <translation>選んだ実験を実行します(Enter)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop the experiment; nothing is written</source>
        <translation>実験を止めます。何も書き込みません</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>レポートを開く</translation>
    </message>
    <message>
        <source>Show the last report in the web browser</source>
        <translation>最後のレポートをブラウザーで表示します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>レポートのフォルダー</translation>
    </message>
    <message>
        <source>Name the folder of the report first.</source>
        <translation>先にレポートのフォルダーを指定してください。</translation>
    </message>
    <message>
        <source>Running “%1”…</source>
        <translation>「%1」を実行中…</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>レポートは %1 にあります。</translation>
    </message>
    <message>
        <source>Runs per case</source>
        <translation>1条件あたりの回数</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Run it</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>記録のフォルダー</translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation>服</translation>
    </message>
    <message>
        <source>Whether the clothes of the simulated people tell them apart</source>
        <translation>シミュレーションの人が服で見分けられるかどうか</translation>
    </message>
    <message>
        <source>both kinds</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>different</source>
        <translation>異なる</translation>
    </message>
    <message>
        <source>similar</source>
        <translation>似ている</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>none: a rendered clip only</source>
        <translation>なし：計算で作った映像のみ</translation>
    </message>
    <message>
        <source>Folder with the recordings juggle1 and otb; without one, a rendered clip only</source>
        <translation>記録 juggle1 と otb のあるフォルダー。なければ計算で作った映像のみ</translation>
    </message>
    <message>
        <source>Choose the folder of the recordings</source>
        <translation>記録のフォルダーを選ぶ</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportDialog</name>
    <message>
        <source>Export trajectory</source>
        <translation>軌跡の書き出し</translation>
    </message>
    <message>
        <source>Write a figure</source>
        <translation>図を書き出す</translation>
    </message>
    <message>
        <source>Figures (*.svg *.pdf)</source>
        <translation>図 (*.svg *.pdf)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>時間 (s)</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>書き出しを中止しました。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>書き出すファイル</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>参照…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>書き出すファイルを選びます</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop the work under way; what is there already stays as it was</source>
        <translation>進行中の作業を止めます。既にあるものはそのまま残ります</translation>
    </message>
    <message>
        <source>Figure…</source>
        <translation>図…</translation>
    </message>
    <message>
        <source>Write a figure of it as SVG or PDF: x, y, z over time and from above</source>
        <translation>図を SVG または PDF で書き出します（x、y、z の時間変化と上から見た図）</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Write the file in the background</source>
        <translation>ファイルをバックグラウンドで書き出します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; an export that is under way goes on</source>
        <translation>閉じます。実行中の書き出しは続きます</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 はすでに存在します。置き換えますか？</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 はすでに存在するため、何も書き込みませんでした。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Which program is to read it</source>
        <translation>どのプログラムで読むか</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Those with a mark are exported; all, if none has one</source>
        <translation>印を付けたものを書き出します。印がなければすべて書き出します</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>推定値</translation>
    </message>
    <message>
        <source>As they were known live, or as all frames before and after tell</source>
        <translation>追跡中に分かっていた値、または前後すべてのフレームから求めた値</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>First time, 0 to 1,000,000 s</source>
        <translation>最初の時刻（0〜1,000,000 s）</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Last time, 0 to 1,000,000 s</source>
        <translation>最後の時刻（0〜1,000,000 s）</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>頻度</translation>
    </message>
    <message>
        <source>Rows per second, 0.001 to 10,000; interpolated</source>
        <translation>1秒あたりの行数（0.001〜10,000）。補間します</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>What to write where the target is not known</source>
        <translation>ターゲットが不明な所に何を書くか</translation>
    </message>
    <message>
        <source>Longest gap</source>
        <translation>最長の欠落</translation>
    </message>
    <message>
        <source>A longer gap is left, 0.01 to 60 s</source>
        <translation>これより長い欠落は残します（0.01〜60 s）</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>世界座標軸</translation>
    </message>
    <message>
        <source>Which axis points up in the file</source>
        <translation>ファイルで上を向く軸</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Unit of positions in the file</source>
        <translation>ファイル内の位置の単位</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>最初</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>最後</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>記録のまま</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> 回/秒</translation>
    </message>
    <message>
        <source>Notes about the run</source>
        <translation>実行の情報</translation>
    </message>
    <message>
        <source>Method, seed, parameters, units and axes as comments in the file</source>
        <translation>手法、シード、パラメータ、単位、軸をコメントとして書きます</translation>
    </message>
    <message>
        <source>live</source>
        <translation>追跡中の値</translation>
    </message>
    <message>
        <source>smoothed after the run</source>
        <translation>実行後に平滑化</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>埋める</translation>
    </message>
    <message>
        <source>as usual in the format</source>
        <translation>形式の標準</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z が上</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y が上</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportOutcome</name>
    <message>
        <source>Show in folder</source>
        <translation>フォルダーに表示</translation>
    </message>
    <message>
        <source>Open the folder of the file that was written</source>
        <translation>書き出したファイルのフォルダーを開きます</translation>
    </message>
    <message>
        <source>No file manager was found. The file is %1.</source>
        <translation>ファイルマネージャーが見つかりません。ファイルは %1 です。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FollowAllButton</name>
    <message numerus="yes">
        <source>Follow all %n of them</source>
        <translation>
            <numerusform>%n 個すべてを追跡</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a target of the same color and size for each of the others</source>
        <translation>ほかの物それぞれに、同じ色と大きさのターゲットを追加します</translation>
    </message>
    <message>
        <source>Follow all of one color</source>
        <translation>同じ色の物をすべて追跡</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GalleryCard</name>
    <message>
        <source>Opening…</source>
        <translation>開いています…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message>
        <source>Gaps of the trajectory</source>
        <translation>軌跡の途切れ</translation>
    </message>
    <message>
        <source>gap from</source>
        <translation>途切れの始め</translation>
    </message>
    <message>
        <source>to</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>target</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n フレーム</numerusform>
        </translation>
    </message>
    <message>
        <source>Seconds from the last held estimate before the gap to the first one after it</source>
        <translation>途切れ前の最後の追跡から、その後の最初の追跡までの秒数</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridForm</name>
    <message>
        <source>Change the reference grid</source>
        <translation>基準格子を変更</translation>
    </message>
    <message>
        <source>Grid on</source>
        <translation>格子の場所</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>a wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>箱</translation>
    </message>
    <message>
        <source>Kind of grid</source>
        <translation>格子の種類</translation>
    </message>
    <message>
        <source>What the grid lies on in the room</source>
        <translation>部屋の何に格子を置くか</translation>
    </message>
    <message>
        <source>Size along x, y, z</source>
        <translation>x、y、z 方向の大きさ</translation>
    </message>
    <message>
        <source>Begins at x, y, z</source>
        <translation>始点 x、y、z</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>%1 方向の大きさ</translation>
    </message>
    <message>
        <source>How far the grid reaches, in meters</source>
        <translation>格子の広がり(メートル)</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>原点 %1</translation>
    </message>
    <message>
        <source>The corner where its axes begin, in meters</source>
        <translation>軸が始まる角(メートル)</translation>
    </message>
    <message>
        <source>Step, turn</source>
        <translation>間隔、回転</translation>
    </message>
    <message>
        <source>Step of the grid</source>
        <translation>格子の間隔</translation>
    </message>
    <message>
        <source>Meters from line to line</source>
        <translation>線と線の間隔(メートル)</translation>
    </message>
    <message>
        <source>Turn of the grid</source>
        <translation>格子の回転</translation>
    </message>
    <message>
        <source>Turned about the vertical, counterclockwise from above</source>
        <translation>鉛直軸まわりの回転(上から見て反時計回り)</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Opacity of the grid</source>
        <translation>格子の不透明度</translation>
    </message>
    <message>
        <source>How strongly the grid is drawn over the images</source>
        <translation>画像の上に格子を描く濃さ</translation>
    </message>
    <message>
        <source>Show edges of the images</source>
        <translation>画像の輪郭を表示</translation>
    </message>
    <message>
        <source>Let the rest of the images step back behind their edges</source>
        <translation>輪郭以外を目立たなくします</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>前の状態</translation>
    </message>
    <message>
        <source>Show the cameras as they were before</source>
        <translation>カメラの以前の状態を表示</translation>
    </message>
    <message>
        <source>While held down (or B, over an image): the grid as it was when the calibration was opened</source>
        <translation>押している間(または画像上で B)、校正を開いたときの格子を表示</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridLayer</name>
    <message>
        <source>Grid over the image of %1</source>
        <translation>%1 の画像の格子</translation>
    </message>
    <message>
        <source>Drag the grid onto the real thing; click to hold a point; arrows, W A S D, Q and E move or turn the camera</source>
        <translation>格子を実物に重ねるようにドラッグ。クリックで点を固定。矢印、W A S D、Q、E でカメラを移動・回転</translation>
    </message>
    <message>
        <source>before</source>
        <translation>前</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistogramView</name>
    <message>
        <source>Colors of the box</source>
        <translation>枠の色</translation>
    </message>
    <message>
        <source>Color histograms of the bounding box: outlined bars for the reference, filled bars for the current frame. The largest of the 512 bins are shown, each in its own color.</source>
        <translation>枠の色ヒストグラム：中空の棒は指定時、塗りつぶした棒は現在です。512個のビンのうち大きいものを、それぞれの色で表示します。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistoryDock</name>
    <message>
        <source>As it was opened</source>
        <translation>開いたときの状態</translation>
    </message>
    <message>
        <source>History of changes</source>
        <translation>変更の履歴</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>元に戻す: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>やり直し: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ImagePickTool</name>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter points there</source>
        <translation>%1 の画像: 矢印キーで十字を動かし、Enter でその場所を指します</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LearnModes</name>
    <message>
        <source>What a click in an image does</source>
        <translation>画像でのクリックの働き</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>学習</translation>
    </message>
    <message>
        <source>Add sample</source>
        <translation>見本を追加</translation>
    </message>
    <message>
        <source>Not this</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Learn the color first: click the target in a camera image.</source>
        <translation>先に色を学習してください。カメラ画像のターゲットをクリックします。</translation>
    </message>
    <message>
        <source>Click: add a sample · Alt: not this · Esc</source>
        <translation>クリック：見本を追加 · Alt：除外 · Esc</translation>
    </message>
    <message>
        <source>Click what is not the target · Esc</source>
        <translation>ターゲットでないものをクリック · Esc</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Alt: not this · Esc</source>
        <translation>クリック：学習 · Shift：追加 · Alt：除外 · Esc</translation>
    </message>
    <message>
        <source>Click the object in a camera image, or drag a box around it.
Shift-click works at any time.</source>
        <translation>カメラ画像で物体をクリックするか、枠で囲みます。
Shift クリックはいつでも使えます。</translation>
    </message>
    <message>
        <source>Click the target in a camera image, or drag a box on it,
to learn its color again.</source>
        <translation>カメラ画像でターゲットをクリックするか、その上で枠を引くと、
色を学習し直します。</translation>
    </message>
    <message>
        <source>Click another part of the target, or the target in different light.
Shift-click works at any time.</source>
        <translation>ターゲットの別の部分、または別の光の当たり方のターゲットをクリックします。
Shift クリックはいつでも使えます。</translation>
    </message>
    <message>
        <source>Click something that matches but is not the target.
Alt-click or Ctrl+Shift-click works at any time.</source>
        <translation>一致するがターゲットではない物をクリックします。
Alt クリックまたは Ctrl+Shift クリックはいつでも使えます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LegendPicture</name>
    <message>
        <source>Cross: the estimate, the weighted mean of the particles.</source>
        <translation>十字：推定。粒子の重み付き平均です。</translation>
    </message>
    <message>
        <source>Unbroken ellipse: with 95 % probability the target is inside. The smaller, the surer.</source>
        <translation>実線の楕円：95 % の確率でターゲットはこの中にあります。小さいほど確かです。</translation>
    </message>
    <message>
        <source>Dashed ellipse: the size of the target itself, where it is not a ball.</source>
        <translation>破線の楕円：ターゲットがボールでない場合の、ターゲット自体の大きさ。</translation>
    </message>
    <message>
        <source>White diamond: where the target really is. Only simulated scenes, such as the demo, know it.</source>
        <translation>白いひし形：ターゲットの真の位置。デモなどシミュレーションのシーンでだけ分かります。</translation>
    </message>
    <message>
        <source>Triangle: the particle of highest weight (View › Show best particle).</source>
        <translation>三角形：重みが最大のパーティクル（表示 › 最良のパーティクルを表示）。</translation>
    </message>
    <message>
        <source>Line through the image: the ray of another camera along which the target must be, while you drag it to where it is.</source>
        <translation>画像を横切る線：ターゲットを実際の位置へドラッグする間に示される、他のカメラの光線。ターゲットはこの線上にあるはずです。</translation>
    </message>
    <message>
        <source>Dots: particles. Each is one guess of where the target is; the brighter, the better it fits the images.</source>
        <translation>点：粒子。それぞれがターゲットの位置の推測です。明るいほど画像によく合います。</translation>
    </message>
    <message>
        <source>Tinted and outlined: where the image has the color of the target (View › Show mask).</source>
        <translation>色と輪郭の付いた所：画像がターゲットの色を持つ所（表示 › マスクを表示）。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MainWindow</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>%1[*] – Dewpoint</source>
        <translation>%1[*] – Dewpoint</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibration</name>
    <message>
        <source>Three points are held already: click one of them to let go of it</source>
        <translation>すでに三点を固定しています。一つをクリックすると外れます</translation>
    </message>
    <message>
        <source>Drag the grid in %1</source>
        <translation>%1 で格子をドラッグ</translation>
    </message>
    <message>
        <source>No further: a point would leave what the camera can see</source>
        <translation>これ以上は動きません: 点がカメラの視界から外れます</translation>
    </message>
    <message>
        <source>No further: the held points and this one lie on one ray or line</source>
        <translation>これ以上は動きません: 固定点とこの点が一直線上にあります</translation>
    </message>
    <message>
        <source>No further: no pose near this one shows the held points where they are</source>
        <translation>これ以上は動きません: 近くに固定点を保つ姿勢がありません</translation>
    </message>
    <message>
        <source>Three held points fix the pose: let go of one, or let the focal length change</source>
        <translation>三点を固定すると姿勢が決まります。一つ外すか、焦点距離の変更を許してください</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>前</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>ピッチ</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>ロール</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>ヨー</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>%1 focal length %2 %</source>
        <translation>%1 焦点距離 %2 %</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibrationPage</name>
    <message>
        <source>Drag the grid in an image until it lies on the real thing. Click a point of it to hold it there.</source>
        <translation>画像の中で格子を実物に重なるまでドラッグします。点をクリックするとそこに固定されます。</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Reference grid</source>
        <translation>基準格子</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手動</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualWindow</name>
    <message>
        <source>Manual – Dewpoint</source>
        <translation>マニュアル – Dewpoint</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>マニュアルのページ</translation>
    </message>
    <message>
        <source>Back to the page before</source>
        <translation>前のページに戻ります</translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation>再び次へ進みます</translation>
    </message>
    <message>
        <source>The manual was not found. It is expected in the folder %1.</source>
        <translation>マニュアルが見つかりません。フォルダー %1 にあるはずです。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MarkerEditor</name>
    <message>
        <source>Name of the mark</source>
        <translation>マークの名前</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <translation>マーク %1</translation>
    </message>
    <message>
        <source>Add a mark</source>
        <translation>マークを追加</translation>
    </message>
    <message>
        <source>Remove a mark</source>
        <translation>マークを削除</translation>
    </message>
    <message>
        <source>Rename a mark</source>
        <translation>マークの名前を変更</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageRow</name>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MissingFilesOffer</name>
    <message>
        <source>%1 was not found in %2.</source>
        <translation>%1 が %2 に見つかりません。</translation>
    </message>
    <message numerus="yes">
        <source>%n files of this project were not found: %1.</source>
        <translation>
            <numerusform>このプロジェクトの %n 個のファイルが見つかりません：%1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>場所を指定…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 の場所を指定</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Opened with the located files. Save the project to keep where they are.</source>
        <translation>場所を指定したファイルで開きました。その場所を残すには、プロジェクトを保存してください。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a file, the name of its camera</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NewProjectPage</name>
    <message>
        <source>New project</source>
        <translation>新しいプロジェクト</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>動画ファイル（カメラごとに1つ）</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>フレームごとに1枚の画像が入ったフォルダー</translation>
    </message>
    <message>
        <source>All cameras connected to this computer</source>
        <translation>このコンピューターに接続されたすべてのカメラ</translation>
    </message>
    <message>
        <source>A device number or a network stream; type it in</source>
        <translation>デバイス番号またはネットワーク映像を入力します</translation>
    </message>
    <message>
        <source>Take the chosen cameras out</source>
        <translation>選んだカメラを取り除きます</translation>
    </message>
    <message>
        <source>Make the project and show its first images</source>
        <translation>プロジェクトを作り、最初の画像を表示します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Back without making a project</source>
        <translation>プロジェクトを作らずに戻ります</translation>
    </message>
    <message>
        <source>Name of the project</source>
        <translation>プロジェクトの名前</translation>
    </message>
    <message>
        <source>Rate of image folders, 0.1 to 10,000 per second</source>
        <translation>画像フォルダーの速度、毎秒0.1〜10,000枚</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Images from</source>
        <translation>画像の元</translation>
    </message>
    <message>
        <source>Cameras of the new project</source>
        <translation>新しいプロジェクトのカメラ</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>カメラごとに動画を選択</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>動画 (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>画像フォルダーを選択</translation>
    </message>
    <message>
        <source>No camera is connected to this computer. A network camera can be added by its address.</source>
        <translation>このコンピューターにはカメラが接続されていません。ネットワークカメラはアドレスで追加できます。</translation>
    </message>
    <message>
        <source>Without a calibration the camera positions are a guess: images can be tracked, but positions in space mean nothing yet.</source>
        <translation>キャリブレーションがないためカメラ位置は推測です。画像での追跡はできますが、空間の位置はまだ意味を持ちません。</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>キャリブレーションのカメラ名が異なるため、順番で対応づけました。</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>動画を追加…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>画像フォルダーを追加…</translation>
    </message>
    <message>
        <source>Add connected cameras</source>
        <translation>接続されたカメラを追加</translation>
    </message>
    <message>
        <source>Add address</source>
        <translation>アドレスを追加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>作成</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名前:</translation>
    </message>
    <message>
        <source>Images per second:</source>
        <translation>1秒あたりの画像数:</translation>
    </message>
    <message>
        <source>Neither a video, nor images, nor a calibration: %1.</source>
        <translation>動画でも画像でもキャリブレーションでもありません: %1。</translation>
    </message>
    <message>
        <source>One row per camera. Videos must be synchronized: frame N shows the same moment in all of them.</source>
        <translation>カメラごとに1行。動画は同期している必要があります: フレーム N はすべての動画で同じ時点を示します。</translation>
    </message>
    <message>
        <source>(folder name)</source>
        <translation>（フォルダー名）</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>検出結果</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OldResultsOffer</name>
    <message>
        <source>Settings changed since this run.</source>
        <translation>この実行の後に設定が変わりました。</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>再追跡</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OverlayLegend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>重ね描きの凡例</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ParameterPanel</name>
    <message>
        <source>The parameters appear here once a project is open.</source>
        <translation>プロジェクトを開くと、ここにパラメーターが表示されます。</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>手法(&amp;M)</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>どれかのカメラ画像で、物をクリックするか、囲むようにドラッグしてください。</translation>
    </message>
    <message>
        <source>This method works in the room: calibrate the cameras first (menu Calibration), their positions are only a guess.</source>
        <translation>この手法は部屋の中の位置を求めます。カメラの位置は仮のものなので、先に較正してください（メニュー「較正」）。</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメーター</translation>
    </message>
    <message>
        <source>More than “%1”: %2 is used.</source>
        <translation>「%1」より大きいため、%2 を使います。</translation>
    </message>
    <message>
        <source>Less than “%1”, which has no effect then.</source>
        <translation>「%1」より小さいため、そちらは効果がありません。</translation>
    </message>
    <message>
        <source>How the targets are tracked. Another method starts again; the rest stays.</source>
        <translation>ターゲットの追跡方法。別の手法にすると最初からやり直し、ほかはそのままです。</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>すべて元に戻す</translation>
    </message>
    <message>
        <source>Give all parameters of this method their defaults</source>
        <translation>この手法のすべてのパラメーターを既定値にします</translation>
    </message>
    <message>
        <source>Volume of interest</source>
        <translation>探索範囲</translation>
    </message>
    <message>
        <source>Targets are searched for in a box alone.</source>
        <translation>ターゲットは箱の中だけで探します。</translation>
    </message>
    <message>
        <source>Something here differs from its default.</source>
        <translation>ここに既定値と異なるものがあります。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeopleDock</name>
    <message>
        <source>People</source>
        <translation>人物</translation>
    </message>
    <message>
        <source>Click somebody in a camera image, or the floor in the bird&apos;s-eye view. Esc ends it.</source>
        <translation>カメラ画像の中の人、または鳥瞰図の床をクリックしてください。Esc で終わります。</translation>
    </message>
    <message>
        <source>Folder for the tables of people</source>
        <translation>人物の表を保存するフォルダー</translation>
    </message>
    <message>
        <source>There are tables of another run in %1. Replace them?</source>
        <translation>%1 に別の実行の表があります。置き換えますか？</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>That run is over; the tables of its people were not written.</source>
        <translation>その実行は終わっているため、人物の表は書き込みませんでした。</translation>
    </message>
    <message>
        <source>Places, volumes, hulls and densities of people are in %1 (frames: %2).</source>
        <translation>人物の位置、体積、凸包、密度を %1 に保存しました（フレーム数：%2）。</translation>
    </message>
    <message>
        <source>Writing the tables of people…</source>
        <translation>人物の表を書き出しています…</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>人物を追加</translation>
    </message>
    <message>
        <source>Remove a person</source>
        <translation>人物を削除</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeoplePanel</name>
    <message>
        <source>People who are there</source>
        <translation>いまいる人物</translation>
    </message>
    <message>
        <source>How much of the empty room is learned</source>
        <translation>空の部屋をどれだけ学習したか</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Number of the person, which nobody else gets in this run</source>
        <translation>人物の番号。この実行では他の人に使われません</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Place in the room, x and y in meters</source>
        <translation>部屋の中の位置、x と y（m）</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>身長</translation>
    </message>
    <message>
        <source>Estimated height, meters; empty: the method does not estimate it</source>
        <translation>推定した身長（m）。空欄：この手法では推定しません</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Meters per second over the floor</source>
        <translation>床の上での秒速（m/s）</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>見える</translation>
    </message>
    <message>
        <source>Cameras that see the person, of all</source>
        <translation>その人物が写っているカメラの数 / 全体</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>Volume of the hull that holds 95 % of the person, cubic meters; empty while hulls are not shown</source>
        <translation>その人物の 95 % を含む凸包の体積（m³）。凸包を表示していない間は空欄</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>How long the person has been there, seconds</source>
        <translation>その人物がいる時間（秒）</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>近く</translation>
    </message>
    <message>
        <source>Somebody else is so near that colors are not learned</source>
        <translation>ほかの人が近すぎるので、色を学習しません</translation>
    </message>
    <message>
        <source>Learning the empty room: %1 %. Keep out of view.</source>
        <translation>空の部屋を学習中：%1 %。画面に入らないでください。</translation>
    </message>
    <message>
        <source>Nobody is there. People appear when two cameras see them.</source>
        <translation>誰もいません。2 台のカメラに写ると人物が現れます。</translation>
    </message>
    <message>
        <source>People there: %1</source>
        <translation>いまいる人数：%1</translation>
    </message>
    <message>
        <source>People appear here once a method for people runs.</source>
        <translation>人物用の手法を実行すると、ここに人物が現れます。</translation>
    </message>
    <message>
        <source>Somebody is near</source>
        <translation>近くに人がいます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlanPage</name>
    <message>
        <source>How well will these cameras measure, and where would one more help? Drag a camera in the bird&apos;s-eye view: the map follows.</source>
        <translation>これらのカメラはどれだけ正確に測れるか、もう1台はどこで役立つか。鳥瞰図でカメラをドラッグすると、マップが追従します。</translation>
    </message>
    <message>
        <source>Map of expected errors</source>
        <translation>予想誤差のマップ</translation>
    </message>
    <message>
        <source>Planned cameras</source>
        <translation>計画中のカメラ</translation>
    </message>
    <message>
        <source>Planned cameras are neither saved with the project nor part of the run. The map takes nothing in the room into account that hides a place.</source>
        <translation>計画中のカメラはプロジェクトに保存されず、実行にも含まれません。マップは室内の遮蔽物を考慮しません。</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>計画</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerForm</name>
    <message>
        <source>Add a camera to plan</source>
        <translation>計画にカメラを追加</translation>
    </message>
    <message>
        <source>A camera that is not there yet: drag it in the bird&apos;s-eye view, or type where it stands (%1)</source>
        <translation>まだ存在しないカメラ：鳥瞰図でドラッグするか位置を入力します（%1）</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Remove the planned camera</source>
        <translation>計画中のカメラを削除</translation>
    </message>
    <message>
        <source>Take the chosen planned camera away</source>
        <translation>選択した計画中のカメラを取り除く</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>計画中のカメラ</translation>
    </message>
    <message>
        <source>The planned camera that the numbers below belong to</source>
        <translation>下の数値が示す計画中のカメラ</translation>
    </message>
    <message>
        <source>Stands at x, y, z</source>
        <translation>位置 x, y, z</translation>
    </message>
    <message>
        <source>Looks at x, y, z</source>
        <translation>注視点 x, y, z</translation>
    </message>
    <message>
        <source>Field of view, image width and height</source>
        <translation>画角、画像の幅と高さ</translation>
    </message>
    <message>
        <source>Planned position %1</source>
        <translation>計画位置 %1</translation>
    </message>
    <message>
        <source>Where the camera stands, in meters</source>
        <translation>カメラの位置（メートル）</translation>
    </message>
    <message>
        <source>Planned camera looks at %1</source>
        <translation>計画中のカメラの注視点 %1</translation>
    </message>
    <message>
        <source>A point on its line of sight, in meters</source>
        <translation>視線上の点（メートル）</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>画角</translation>
    </message>
    <message>
        <source>How wide the camera sees, from left to right</source>
        <translation>カメラが見る広さ（左右）</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Pixels of its image, from left to right</source>
        <translation>画像のピクセル数（左右）</translation>
    </message>
    <message>
        <source>Image height</source>
        <translation>画像の高さ</translation>
    </message>
    <message>
        <source>Pixels of its image, from top to bottom</source>
        <translation>画像のピクセル数（上下）</translation>
    </message>
    <message>
        <source>Walls and ceiling outside the volume by</source>
        <translation>壁と天井の空間からの距離</translation>
    </message>
    <message>
        <source>Distance of the walls</source>
        <translation>壁の距離</translation>
    </message>
    <message>
        <source>The search looks on the four walls and the ceiling around the volume, this far outside of it</source>
        <translation>空間を囲む4つの壁と天井（この距離だけ外側）を探索します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>探索をキャンセル</translation>
    </message>
    <message>
        <source>End the search; nothing is added</source>
        <translation>探索を終了します。何も追加されません</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>未選択</translation>
    </message>
    <message>
        <source>Find the best place for %1</source>
        <translation>%1 の最適な場所を探す</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the place from which one more camera helps most (%1)</source>
        <translation>もう1台のカメラが最も役立つ場所を壁と天井で探します（%1）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerInstaller</name>
    <message>
        <source>Move %1 in the bird&apos;s-eye view</source>
        <translation>鳥瞰図で %1 を移動</translation>
    </message>
    <message>
        <source>Turn %1 in the bird&apos;s-eye view</source>
        <translation>鳥瞰図で %1 を回転</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotPanel</name>
    <message>
        <source>Plots of the run</source>
        <translation>実行のグラフ</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Choose the plots shown; copy or save them</source>
        <translation>表示するグラフの選択、コピー、保存</translation>
    </message>
    <message>
        <source>Choose the plots shown</source>
        <translation>表示するグラフを選択</translation>
    </message>
    <message>
        <source>The plots are on the clipboard as CSV.</source>
        <translation>グラフを CSV でクリップボードにコピーしました。</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>グラフを保存</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Pictures (*.png)</source>
        <translation>図面 (*.svg);;画像 (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 を書き込めませんでした。</translation>
    </message>
    <message>
        <source>Plots appear when tracking runs.</source>
        <translation>追跡を実行すると、グラフが表示されます。</translation>
    </message>
    <message>
        <source>The target whose numbers are plotted: the one selected in Target, or the first.</source>
        <translation>数値をグラフにするターゲット：「ターゲット」で選択したもの、なければ最初のもの。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotStack</name>
    <message>
        <source>frame %1, iteration %2, %3</source>
        <translation>フレーム %1、反復 %2、%3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointCalibrator</name>
    <message>
        <source>%1 is rotated and mirrored: turn its images clockwise by %2 degrees, then mirror them</source>
        <translation>%1 は回転し、鏡像です: 画像を時計回りに %2 度回してから反転してください</translation>
    </message>
    <message>
        <source>%1 is mirrored</source>
        <translation>%1 は鏡像です</translation>
    </message>
    <message>
        <source>%1 is rotated: turn its images clockwise by %2 degrees</source>
        <translation>%1 は回転しています: 画像を時計回りに %2 度回してください</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>Add measured point</source>
        <translation>測定点を追加</translation>
    </message>
    <message>
        <source>Remove measured point</source>
        <translation>測定点を削除</translation>
    </message>
    <message>
        <source>Rename measured point</source>
        <translation>測定点の名前を変更</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>%1 の位置</translation>
    </message>
    <message>
        <source>Click %1 in %2</source>
        <translation>%2 で %1 をクリック</translation>
    </message>
    <message>
        <source>Forget %1 in %2</source>
        <translation>%2 の %1 を消す</translation>
    </message>
    <message>
        <source>Solve cameras from measured points</source>
        <translation>測定点からカメラを求める</translation>
    </message>
    <message>
        <source>No point was clicked yet: choose one, then click it in the images</source>
        <translation>まだ点がクリックされていません。点を選び、画像でクリックしてください</translation>
    </message>
    <message>
        <source>%1: %2 off on average</source>
        <translation>%1: 平均 %2 のずれ</translation>
    </message>
    <message>
        <source>%1: %2 points are too few, click four or more</source>
        <translation>%1: %2 点では足りません。四点以上クリックしてください</translation>
    </message>
    <message>
        <source>%1: its points lie on one line, add one beside it</source>
        <translation>%1: 点が一直線上にあります。外れた点を加えてください</translation>
    </message>
    <message>
        <source>%1: %2, but a second pose fits as well: add a point outside the plane</source>
        <translation>%1: %2 ですが、別の姿勢も同じくらい合います。平面の外の点を加えてください</translation>
    </message>
    <message>
        <source>%1: no pose shows the points there</source>
        <translation>%1: その位置に点が見える姿勢がありません</translation>
    </message>
    <message>
        <source>%1, unless it was mounted so</source>
        <translation>%1(わざとそう取り付けた場合を除く)</translation>
    </message>
    <message>
        <source>%1: then its points fit to %2</source>
        <translation>%1: そうすると点が %2 で合います</translation>
    </message>
    <message>
        <source>%1 does not fit the rest (%2, %3): measure or click it again</source>
        <translation>%1 は他と合いません (%2、%3)。測り直すかクリックし直してください</translation>
    </message>
    <message>
        <source>Worst: %1 (%2, %3)</source>
        <translation>最大のずれ: %1 (%2、%3)</translation>
    </message>
    <message>
        <source>Set how %1 lies</source>
        <translation>%1 の画像の向きを設定</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointsTable</name>
    <message>
        <source>Measured points</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>Places measured with a tape, in meters: double click to type. A marked row fits worst.</source>
        <translation>巻尺で測った位置(メートル)。ダブルクリックで入力。印の付いた行が最も合いません。</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x m</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y m</translation>
    </message>
    <message>
        <source>z m</source>
        <translation>z m</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>可視</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>点を追加</translation>
    </message>
    <message>
        <source>Add a place of the room that you measured</source>
        <translation>測った場所を追加します</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>点を削除</translation>
    </message>
    <message>
        <source>Remove the chosen point</source>
        <translation>選んだ点を削除します</translation>
    </message>
    <message>
        <source>Click in images</source>
        <translation>画像でクリック</translation>
    </message>
    <message>
        <source>Then click the chosen point in every image that shows it: corners are found to a fraction of a pixel (Alt: exactly where you click). Esc ends it.</source>
        <translation>選んだ点を、写っているすべての画像でクリックします。角はピクセル以下の精度で見つかります (Alt: クリックした場所そのまま)。Esc で終了。</translation>
    </message>
    <message>
        <source>Forget click</source>
        <translation>クリックを消す</translation>
    </message>
    <message>
        <source>Forget the click of this point in the chosen camera</source>
        <translation>選んだカメラでのこの点のクリックを消します</translation>
    </message>
    <message>
        <source>Solve focal lengths too</source>
        <translation>焦点距離も求める</translation>
    </message>
    <message>
        <source>For cameras with six points or more</source>
        <translation>六点以上あるカメラだけ</translation>
    </message>
    <message>
        <source>Solve cameras</source>
        <translation>カメラを求める</translation>
    </message>
    <message>
        <source>Find the poses of all cameras in which points were clicked; four points or more each</source>
        <translation>点をクリックしたすべてのカメラの姿勢を求めます(各四点以上)</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2、%3</translation>
    </message>
    <message>
        <source>Set it: %1</source>
        <translation>設定: %1</translation>
    </message>
    <message>
        <source>Turn or mirror the images of this camera so, and solve again</source>
        <translation>このカメラの画像をそのように回転・反転し、もう一度求めます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PreviewPane</name>
    <message>
        <source>Working on the preview: %1 %</source>
        <translation>プレビューを作成中:%1 %</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>ファイルの先頭行</translation>
    </message>
    <message>
        <source>Units and axes</source>
        <translation>単位と軸</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Some of these results are of earlier settings.</source>
        <translation>この結果の一部は以前の設定によるものです。</translation>
    </message>
    <message>
        <source>The preview was stopped. The next change begins it anew.</source>
        <translation>プレビューを止めました。次に何かを変えると、また始まります。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProblemReport</name>
    <message>
        <source>Report a problem – Dewpoint</source>
        <translation>問題を報告 – Dewpoint</translation>
    </message>
    <message>
        <source>Write to those who gave you Dewpoint: what you did, what you expected, and what happened instead. Add the text below, and, if you can, the project file and a screenshot. Nothing is sent by itself.</source>
        <translation>Dewpoint の提供元に、何をしたか、何を期待したか、実際に何が起きたかを知らせてください。下のテキストと、できればプロジェクトファイルとスクリーンショットを添えてください。自動で送信されるものはありません。</translation>
    </message>
    <message>
        <source>Text for the report</source>
        <translation>報告用のテキスト</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the text, to be pasted into a mail or a form</source>
        <translation>メールやフォームに貼り付けるためにテキストをコピーします</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectController</name>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>どれかのカメラ画像で、物をクリックするか、囲むようにドラッグしてください。</translation>
    </message>
    <message>
        <source>Click the thing to follow in any image: its color is learned and tracking starts.</source>
        <translation>どの画像でも追跡したいものをクリックすると、その色を学習して追跡を始めます。</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml);;All files (*)</source>
        <translation>Dewpoint プロジェクト (*.toml);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Recovered. Save the project to keep it.</source>
        <translation>復元しました。残すにはプロジェクトを保存してください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::QuickStart</name>
    <message>
        <source>The cameras confirm where the target is.</source>
        <translation>カメラがターゲットの位置を裏付けています。</translation>
    </message>
    <message>
        <source>Something else fits about as well. Press X and drag the target to where it is.</source>
        <translation>ほかにも同じくらい合うものがあります。X を押してターゲットを実際の位置へドラッグしてください。</translation>
    </message>
    <message>
        <source>Not found yet, or not seen for less than a second.</source>
        <translation>まだ見つかっていないか、見えなくなって 1 秒未満です。</translation>
    </message>
    <message>
        <source>Not seen for a second. The line at the bottom says why.</source>
        <translation>1 秒間見えていません。理由は下端の行に表示されます。</translation>
    </message>
    <message>
        <source>Quick start – Dewpoint</source>
        <translation>クイックスタート – Dewpoint</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>見えるもの</translation>
    </message>
    <message>
        <source>Each camera view shows its image, and over it what the program believes. The bird&apos;s-eye view shows the same in the room.</source>
        <translation>各カメラビューは画像と、その上にプログラムの推定を表示します。鳥瞰図は同じものを部屋の中で表示します。</translation>
    </message>
    <message>
        <source>How sure it is</source>
        <translation>どれだけ確かか</translation>
    </message>
    <message>
        <source>How to begin</source>
        <translation>始め方</translation>
    </message>
    <message>
        <source>1.  Open one video per camera, or connect cameras: File › New project (%1). Or try the demo first.</source>
        <translation>1.  カメラごとに動画を1つ開くか、カメラを接続します：ファイル › 新しいプロジェクト（%1）。先にデモを試すこともできます。</translation>
    </message>
    <message>
        <source>2.  Give the calibration of the cameras, or make one: menu Calibration (%1 to begin by hand). Without it, targets are tracked in the images only.</source>
        <translation>2.  カメラのキャリブレーションを指定するか、作成します：メニュー「キャリブレーション」（手動で始めるには %1）。なければ、ターゲットは画像の中だけで追跡されます。</translation>
    </message>
    <message>
        <source>3.  Click the thing to follow in any image. Its color is learned in all cameras, and tracking starts.</source>
        <translation>3.  どれかの画像で追跡したいものをクリックします。すべてのカメラで色が学習され、追跡が始まります。</translation>
    </message>
    <message>
        <source>4.  Press %1 to play and to pause. Drag along the timeline to look back: every view shows that frame as it was.</source>
        <translation>4.  %1 を押すと再生または一時停止します。タイムラインをドラッグすると過去を表示できます：すべてのビューがそのフレームを当時のまま表示します。</translation>
    </message>
    <message>
        <source>5.  Export the trajectory: File › Export trajectory (%1).</source>
        <translation>5.  軌跡を書き出します：ファイル › 軌跡を書き出す（%1）。</translation>
    </message>
    <message>
        <source>All signs…</source>
        <translation>すべての記号…</translation>
    </message>
    <message>
        <source>Open the legend of all that is drawn over the images</source>
        <translation>画像に重ねて描かれるすべての凡例を開きます</translation>
    </message>
    <message>
        <source>Manual…</source>
        <translation>マニュアル…</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>マニュアルを開きます</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentList</name>
    <message>
        <source>The file is gone</source>
        <translation>ファイルがなくなっています</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentMenu</name>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>履歴を消去</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecoveryOffer</name>
    <message>
        <source>Dewpoint did not end properly. Unsaved work on “%1” is from %2.</source>
        <translation>Dewpoint は正常に終了しませんでした。「%1」の未保存の作業（%2）があります。</translation>
    </message>
    <message>
        <source>Recover it</source>
        <translation>復元する</translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation>破棄する</translation>
    </message>
    <message>
        <source>Unsaved work on “%1” was thrown away.</source>
        <translation>「%1」の未保存の作業を破棄しました。</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>元に戻す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RigPlanner</name>
    <message>
        <source>Put %1 here: x %2, y %3, z %4. Then %5 of the volume is within %6, instead of %7.</source>
        <translation>%1 をここに置く：x %2、y %3、z %4。空間の %5 が %6 以内になります（現在は %7）。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunAlerts</name>
    <message>
        <source>No camera was bumped.</source>
        <translation>動いたカメラはありません。</translation>
    </message>
    <message>
        <source>%1 cannot be solved again now.</source>
        <translation>%1 は今は解き直せません。</translation>
    </message>
    <message>
        <source>Re-solve %1</source>
        <translation>%1 を解き直す</translation>
    </message>
    <message>
        <source>%1 is calibrated as it stands now. Undo takes it back.</source>
        <translation>%1 を現在の姿勢に校正しました。元に戻すで取り消せます。</translation>
    </message>
    <message>
        <source>The target was %1 beside where the others see it, and is %2 now.</source>
        <translation>ターゲットは他のカメラが見る位置から %1 ずれていましたが、今は %2 です。</translation>
    </message>
    <message>
        <source>Done: %1. Undo takes it back.</source>
        <translation>完了: %1。「元に戻す」で取り消せます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunDetails</name>
    <message>
        <source>median %1, 99 of 100 within %2, longest %3</source>
        <translation>中央値 %1、100 回中 99 回は %2 以内、最長 %3</translation>
    </message>
    <message>
        <source>none is set</source>
        <translation>設定なし</translation>
    </message>
    <message>
        <source>%1, kept in %2 % of the iterations of this run</source>
        <translation>%1、この実行の反復の %2 % で守られました</translation>
    </message>
    <message>
        <source>Time per iteration, median</source>
        <translation>1 反復の時間（中央値）</translation>
    </message>
    <message>
        <source>From a frame to its estimate</source>
        <translation>フレームからその推定まで</translation>
    </message>
    <message>
        <source>Time budget per iteration</source>
        <translation>1 反復の時間の上限</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>有効サンプルサイズ</translation>
    </message>
    <message>
        <source>Iterations since the start</source>
        <translation>開始からの反復</translation>
    </message>
    <message>
        <source>Frames skipped</source>
        <translation>飛ばしたフレーム</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>乱数のシード</translation>
    </message>
    <message>
        <source>Kept of the past</source>
        <translation>保持している過去</translation>
    </message>
    <message>
        <source>%1 of %2 particles</source>
        <translation>粒子 %1 / %2</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 / %2 MB</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SessionController</name>
    <message>
        <source>Restart the run? What was tracked so far is lost.</source>
        <translation>実行を最初からやり直しますか？これまでの追跡結果は失われます。</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Use image size</source>
        <translation>画像のサイズを取り込む</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>操作を検索</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>説明</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>操作とショートカット</translation>
    </message>
    <message>
        <source>Click here and press the new keys of the chosen action</source>
        <translation>ここをクリックし、選んだ操作の新しいキーを押してください</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>新しいショートカット</translation>
    </message>
    <message>
        <source>No shortcut</source>
        <translation>ショートカットなし</translation>
    </message>
    <message>
        <source>Take the shortcut of the chosen action away</source>
        <translation>選んだ操作のショートカットを外します</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>すべて元に戻す</translation>
    </message>
    <message>
        <source>All shortcuts as they were at first</source>
        <translation>すべてのショートカットを最初の状態にします</translation>
    </message>
    <message>
        <source>Choose an action, click into the field below and press the new keys.</source>
        <translation>操作を選び、下の欄をクリックして新しいキーを押してください。</translation>
    </message>
    <message>
        <source>“%1” has no shortcut now.</source>
        <translation>「%1」のショートカットはなくなりました。</translation>
    </message>
    <message>
        <source>All shortcuts are as they were at first.</source>
        <translation>すべてのショートカットは最初の状態です。</translation>
    </message>
    <message>
        <source>“%1” is now %2.</source>
        <translation>「%1」は %2 になりました。</translation>
    </message>
    <message>
        <source>“%1” is now %2; “%3” has lost it.</source>
        <translation>「%1」は %2 になり、「%3」からは外れました。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; changed shortcuts are kept already</source>
        <translation>閉じる（変更したショートカットは保存済み）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SpeedButton</name>
    <message>
        <source>1/%1 ×</source>
        <comment>speed</comment>
        <translation>1/%1 倍</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <comment>speed</comment>
        <translation>%1 倍</translation>
    </message>
    <message>
        <source>How fast the recording is played. Live cameras are always tracked as they come.</source>
        <translation>録画を再生する速さ。ライブカメラは常に届くままに追跡します。</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>再生速度</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StartPage</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>デモを試す</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近のプロジェクト</translation>
    </message>
    <message>
        <source>You can also drop a project or videos onto this window.</source>
        <translation>プロジェクトや動画をこのウィンドウにドロップすることもできます。</translation>
    </message>
    <message>
        <source>Watch it converge</source>
        <translation>収束を見る</translation>
    </message>
    <message>
        <source>A cloud of guesses slides along a line of sight and snaps onto the ball.</source>
        <translation>推測の雲が視線に沿って滑り、ボールにぴたりと集まります。</translation>
    </message>
    <message>
        <source>Hidden for a second</source>
        <translation>1 秒間隠れる</translation>
    </message>
    <message>
        <source>A box passes in front of the ball. One camera is enough to keep it.</source>
        <translation>箱がボールの前を横切ります。カメラ 1 台だけで追跡を保てます。</translation>
    </message>
    <message>
        <source>Three more balls of the same color lie around. Only one moves.</source>
        <translation>同じ色のボールがほかに 3 つ置かれています。動くのは 1 つだけです。</translation>
    </message>
    <message>
        <source>People in an office</source>
        <translation>オフィスの人々</translation>
    </message>
    <message>
        <source>Four cameras carve everybody out of space, and give each a number.</source>
        <translation>4 台のカメラが全員を空間から切り出し、それぞれに番号を付けます。</translation>
    </message>
    <message>
        <source>One camera and a box</source>
        <translation>カメラ 1 台と枠</translation>
    </message>
    <message>
        <source>No calibration: a box in the image is followed by its colors.</source>
        <translation>キャリブレーションなし：画像の中の枠を色で追跡します。</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>手動で校正</translation>
    </message>
    <message>
        <source>Drag a grid over the images until it lies on the floor.</source>
        <translation>画像の上で格子を床に重なるまでドラッグします。</translation>
    </message>
    <message>
        <source>Follow colored objects in 3D with ordinary cameras.</source>
        <translation>普通のカメラで、色の付いた物体を 3D で追跡します。</translation>
    </message>
    <message>
        <source>Two simulated cameras see a pink ball; a particle filter finds it and follows it through space. Pause, look back, change everything: nothing can break.</source>
        <translation>2 台のシミュレーションのカメラがピンクのボールを見ています。パーティクルフィルタがそれを見つけ、空間を追跡します。一時停止しても、過去を表示しても、何を変えても、壊れることはありません。</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>自分のデータ</translation>
    </message>
    <message>
        <source>Open videos…</source>
        <translation>動画を開く…</translation>
    </message>
    <message>
        <source>One recording per camera</source>
        <translation>カメラごとに録画 1 つ</translation>
    </message>
    <message>
        <source>Use cameras…</source>
        <translation>カメラを使う…</translation>
    </message>
    <message>
        <source>Connected ones, or network streams</source>
        <translation>接続されたカメラ、またはネットワーク映像</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>One that was saved before</source>
        <translation>以前に保存したもの</translation>
    </message>
    <message>
        <source>Four balls alike</source>
        <translation>そっくりな 4 つのボール</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StatusBarPanel</name>
    <message>
        <source>playing</source>
        <translation>再生中</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Frame shown, of all frames</source>
        <translation>表示中のフレーム / 全フレーム</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Frames tracked per second</source>
        <translation>1 秒あたりに追跡したフレーム数</translation>
    </message>
    <message>
        <source>Estimated position of the target in the room</source>
        <translation>部屋の中での目標の推定位置</translation>
    </message>
    <message>
        <source>frame %1 / %2</source>
        <translation>フレーム %1 / %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3</source>
        <translation>x %1  y %2  z %3</translation>
    </message>
    <message>
        <source>tracking again</source>
        <translation>再追跡中</translation>
    </message>
    <message>
        <source>looking back</source>
        <translation>過去を表示中</translation>
    </message>
    <message>
        <source>Playing, paused, at the end, looking back at an earlier moment, or tracking it again</source>
        <translation>再生中、一時停止、終端、過去の時点を表示中、または再追跡中</translation>
    </message>
    <message>
        <source>held where it is thought to be</source>
        <translation>あると思われる場所に保っています</translation>
    </message>
    <message>
        <source>click it or drag a box around it</source>
        <translation>クリックするか、囲むようにドラッグ</translation>
    </message>
    <message>
        <source>x %1  y %2  %3 × %4</source>
        <translation>x %1  y %2  %3 × %4</translation>
    </message>
    <message>
        <source>● people: %1</source>
        <translation>● 人物：%1</translation>
    </message>
    <message>
        <source>○ people: %1, searching</source>
        <translation>○ 人物：%1、探索中</translation>
    </message>
    <message>
        <source>others fit as well: press X, drag the target</source>
        <translation>ほかも同じくらい合います：X を押してターゲットをドラッグ</translation>
    </message>
    <message>
        <source>Held: the cameras confirm the estimate. Ambiguous: something else fits about as well. Lost: not held for a second.</source>
        <translation>追跡中：カメラが推定を裏付けています。あいまい：ほかにも同じくらい合うものがあります。見失い：1 秒間追跡できていません。</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>How exactly the position is known: the standard deviation in 3D, x, y and z together (the plots show each)</source>
        <translation>位置がどれだけ正確に分かっているか：x、y、z を合わせた 3D の標準偏差（それぞれはグラフに表示）</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>Speed of the target in the room</source>
        <translation>部屋の中でのターゲットの速さ</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Times, particles, and what is kept of the past</source>
        <translation>時間、粒子、保持している過去</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name of the target, in views and files</source>
        <translation>表示やファイルで使うターゲットの名前</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Radius of the ball, 0 to 2,000 mm. Unknown: it is estimated.</source>
        <translation>ボールの半径、0〜2,000 mm。不明の場合は推定します。</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>ボール</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Ball: its outline is a circle in every image. Any: its extent is learned, and its center is that of its color. Automatic: the images decide. Only method dewpoint uses this.</source>
        <translation>ボール: どの画像でも輪郭は円です。任意: 広がりを学習し、中心はその色の中心です。自動: 画像から判断します。手法 dewpoint だけが使います。</translation>
    </message>
    <message>
        <source>No target yet: click the thing to follow in any camera image.</source>
        <translation>ターゲットはまだありません。カメラ画像で追跡したいものをクリックしてください。</translation>
    </message>
    <message>
        <source>The color of a target is learned by clicking it in a camera image.</source>
        <translation>カメラ画像でターゲットをクリックすると色を学習します。</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>ターゲットの名前を変更</translation>
    </message>
    <message>
        <source>Change radius</source>
        <translation>半径を変更</translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation>形状を変更</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>ターゲットを取り除く</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view: it is followed from there on.</source>
        <translation>どれかのカメラ画像で、物をクリックするか、囲むようにドラッグしてください。そこから追跡します。</translation>
    </message>
    <message>
        <source>No box at this moment.</source>
        <translation>この時点では枠がありません。</translation>
    </message>
    <message>
        <source>%1, in %2
Center %3, %4, size %5 × %6
Similarity %7
Effective sample size %8 of %9</source>
        <translation>%1（%2）
中心 %3, %4、大きさ %5 × %6
類似度 %7
有効サンプル数 %8 / %9</translation>
    </message>
    <message>
        <source>Spread %1</source>
        <translation>広がり %1</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>半径 %1</translation>
    </message>
    <message>
        <source>radius %1 (found)</source>
        <translation>半径 %1（推定）</translation>
    </message>
    <message>
        <source>radius unknown</source>
        <translation>半径不明</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Add target</source>
        <translation>ターゲットを追加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>学習</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ThreadCountDialog</name>
    <message>
        <source>Filter threads</source>
        <translation>フィルターのスレッド数</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>スレッド数</translation>
    </message>
    <message>
        <source>as suits this machine</source>
        <translation>このコンピューターに合わせる</translation>
    </message>
    <message>
        <source>How many threads share the work of the filter; results are the same with any number</source>
        <translation>フィルターの処理を分担するスレッド数。いくつでも結果は同じです</translation>
    </message>
    <message>
        <source>Used from the next frame on.</source>
        <translation>次のフレームから使われます。</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Keep this number</source>
        <translation>この数にする</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>何も変更しない</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Timeline</name>
    <message>
        <source>Memory for going back in the run: images, particles and copies of the method. When it is full, older moments keep their estimates only.</source>
        <translation>実行をさかのぼるためのメモリ: 画像、パーティクル、手法の複製。いっぱいになると、古い時点は推定値だけが残ります。</translation>
    </message>
    <message>
        <source>Nothing tracked yet: play (Space), then drag here through time.</source>
        <translation>まだ追跡していません: 再生 (スペース) してから、ここをドラッグして時間を移動します。</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>The change holds from now on. “%1” shows what it makes of this moment.</source>
        <translation>変更は今後に適用されます。「%1」でこの時点からの結果を確かめられます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TouchedInstantList</name>
    <message>
        <source>The ball %1</source>
        <translation>ボールが%1</translation>
    </message>
    <message>
        <source>What the ball does at the moment</source>
        <translation>その瞬間のボールの状態</translation>
    </message>
    <message>
        <source>Three places of the floor, or a fall, tell where up is</source>
        <translation>床の3か所、または落下から上の向きが分かります</translation>
    </message>
    <message>
        <source>Take this moment</source>
        <translation>この瞬間を取り込む</translation>
    </message>
    <message>
        <source>The moment that the images show is one at which the ball does this</source>
        <translation>表示中の瞬間に、ボールはこの状態です</translation>
    </message>
    <message>
        <source>Remove moment</source>
        <translation>瞬間を除く</translation>
    </message>
    <message>
        <source>Take the chosen moment off the list</source>
        <translation>選んだ瞬間を一覧から除く</translation>
    </message>
    <message>
        <source>Moments taken</source>
        <translation>取り込んだ瞬間</translation>
    </message>
    <message>
        <source>Double click or Enter shows the moment</source>
        <translation>ダブルクリックまたは Enter でその瞬間を表示</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryModel</name>
    <message>
        <source>● held</source>
        <translation>● 追跡中</translation>
    </message>
    <message>
        <source>○ not held</source>
        <translation>○ 未追跡</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>時間, s</translation>
    </message>
    <message>
        <source>Seconds, of the frame</source>
        <translation>フレームの時刻（秒）</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>1 から数えたフレーム番号</translation>
    </message>
    <message>
        <source>target</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>ターゲットの名前</translation>
    </message>
    <message>
        <source>%1, m</source>
        <translation>%1, m</translation>
    </message>
    <message>
        <source>Position in the room, meters</source>
        <translation>室内での位置（メートル）</translation>
    </message>
    <message>
        <source>σ%1, mm</source>
        <translation>σ%1, mm</translation>
    </message>
    <message>
        <source>Standard deviation of the position, millimeters</source>
        <translation>位置の標準偏差（ミリメートル）</translation>
    </message>
    <message>
        <source>speed, m/s</source>
        <translation>速さ, m/s</translation>
    </message>
    <message>
        <source>Speed, meters per second: fitted over five frames</source>
        <translation>速さ（メートル毎秒、5 フレームに当てはめ）</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Cameras that see the target</source>
        <translation>ターゲットが見えているカメラの数</translation>
    </message>
    <message>
        <source>existence</source>
        <translation>存在確率</translation>
    </message>
    <message>
        <source>Probability that the target is where the estimate says</source>
        <translation>推定どおりの位置にターゲットがある確率</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>◆ corrected</source>
        <translation>◆ 修正済み</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ あいまい</translation>
    </message>
    <message>
        <source>Held: the cameras confirm the estimate. Ambiguous: something else fits about as well. Corrected: you said where the target is</source>
        <translation>追跡中：カメラが推定を裏付けています。あいまい：ほかにも同じくらい合うものがあります。修正済み：ターゲットの位置をあなたが指定しました</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message>
        <source>Trajectory</source>
        <translation>軌跡</translation>
    </message>
    <message>
        <source>Speed and height over time</source>
        <translation>時間に対する速さと高さ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n 行を CSV としてクリップボードにコピーしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The trajectory appears here as soon as the target is tracked.</source>
        <translation>ターゲットの追跡が始まると、ここに軌跡が表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n サンプル</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n サンプル、欠落なし</numerusform>
        </translation>
    </message>
    <message>
        <source>The boxes are on the clipboard as CSV.</source>
        <translation>枠を CSV としてクリップボードにコピーしました。</translation>
    </message>
    <message>
        <source>Remove the correction</source>
        <translation>修正を取り消す</translation>
    </message>
    <message>
        <source>Speed and height appear when tracking runs.</source>
        <translation>追跡を実行すると、速さと高さが表示されます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::UncertaintyMapForm</name>
    <message>
        <source>Show the map in the bird&apos;s-eye view</source>
        <translation>鳥瞰図にマップを表示</translation>
    </message>
    <message>
        <source>How far off a target is expected to be at each place; it follows every move of a camera</source>
        <translation>各場所でターゲットがどれだけずれると予想されるか。カメラの動きに追従します</translation>
    </message>
    <message>
        <source>Colors show</source>
        <translation>色の意味</translation>
    </message>
    <message>
        <source>the expected error</source>
        <translation>予想誤差</translation>
    </message>
    <message>
        <source>the number of cameras</source>
        <translation>カメラの数</translation>
    </message>
    <message>
        <source>What the colors show</source>
        <translation>色が示すもの</translation>
    </message>
    <message>
        <source>The expected error (standard deviation along the worst direction), or how many cameras see a place</source>
        <translation>予想誤差（最も悪い方向の標準偏差）、またはその場所が見えるカメラの数</translation>
    </message>
    <message>
        <source>Good enough</source>
        <translation>十分な精度</translation>
    </message>
    <message>
        <source>The error that is good enough: up to it the map is blue, and it is what the sentence and the search for a place go by</source>
        <translation>十分とみなす誤差：ここまでマップは青く、文と場所の探索もこれに従います</translation>
    </message>
    <message>
        <source>Error of a sighting</source>
        <translation>観測の誤差</translation>
    </message>
    <message>
        <source>How far off a target is found in an image, in pixels (one standard deviation)</source>
        <translation>画像内で見つかるターゲットのずれ（ピクセル、標準偏差）</translation>
    </message>
    <message>
        <source>Layer at</source>
        <translation>層の高さ</translation>
    </message>
    <message>
        <source>Show the map in a horizontal layer</source>
        <translation>水平な層にマップを表示</translation>
    </message>
    <message>
        <source>Height of the layer</source>
        <translation>層の高さ（スライダー）</translation>
    </message>
    <message>
        <source>Height of the layer above the floor</source>
        <translation>床からの層の高さ</translation>
    </message>
    <message>
        <source>Height of the layer in meters</source>
        <translation>層の高さ（メートル）</translation>
    </message>
    <message>
        <source>Volume: surfaces around what is good and what is fair</source>
        <translation>空間：良い範囲とまずまずの範囲を囲む面</translation>
    </message>
    <message>
        <source>Show through the room where the error is at most 0.4, 1 and 2 times what is good enough, or where two, three and four cameras see</source>
        <translation>誤差が十分な値の0.4倍、1倍、2倍以下の範囲、または2台、3台、4台のカメラから見える範囲を空間全体で表示</translation>
    </message>
    <message>
        <source>Volume from x, y, z</source>
        <translation>空間の始まり x, y, z</translation>
    </message>
    <message>
        <source>to x, y, z</source>
        <translation>終わり x, y, z</translation>
    </message>
    <message>
        <source>Volume from %1</source>
        <translation>空間の始まり %1</translation>
    </message>
    <message>
        <source>Where the volume begins, in meters</source>
        <translation>空間の始まり（メートル）</translation>
    </message>
    <message>
        <source>Volume to %1</source>
        <translation>空間の終わり %1</translation>
    </message>
    <message>
        <source>Where the volume ends, in meters</source>
        <translation>空間の終わり（メートル）</translation>
    </message>
    <message>
        <source>Like the reference grid</source>
        <translation>基準グリッドに合わせる</translation>
    </message>
    <message>
        <source>The volume above the reference grid, up to the highest camera</source>
        <translation>基準グリッドの上、最も高いカメラまでの空間</translation>
    </message>
    <message>
        <source>%1 of the volume within %2, %3 seen by fewer than two cameras</source>
        <translation>空間の %1 が %2 以内、%3 は見えるカメラが2台未満</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewButtons</name>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Look from above: X to the right, Y up. Drag to move, wheel to zoom, double click to see everything.</source>
        <translation>上から見る：X は右、Y は上。ドラッグで移動、ホイールで拡大縮小、ダブルクリックで全体を表示。</translation>
    </message>
    <message>
        <source>Look from the front: X to the right, Z up. Drag to move, wheel to zoom, double click to see everything.</source>
        <translation>正面から見る：X は右、Z は上。ドラッグで移動、ホイールで拡大縮小、ダブルクリックで全体を表示。</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>See everything again, in the same view. Double click does it too.</source>
        <translation>同じ視点でもう一度全体を表示。ダブルクリックでも可。</translation>
    </message>
    <message>
        <source>Perspective view. Drag to orbit, Shift-drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>透視図。ドラッグで回転、Shift を押しながらドラッグで移動、ホイールで拡大縮小、ダブルクリックで全体を表示。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewPictures</name>
    <message>
        <source>Save picture as PNG…</source>
        <translation>画像を PNG で保存…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>画像をコピー</translation>
    </message>
    <message>
        <source>Save a picture of %1</source>
        <translation>%1 の画像を保存</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Saved the picture %1.</source>
        <translation>画像 %1 を保存しました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VolumeForm</name>
    <message>
        <source>From X, Y, Z</source>
        <translation>始点 X, Y, Z</translation>
    </message>
    <message>
        <source>To X, Y, Z</source>
        <translation>終点 X, Y, Z</translation>
    </message>
    <message>
        <source>Volume of interest from %1</source>
        <translation>探索範囲の始点 %1</translation>
    </message>
    <message>
        <source>Volume of interest to %1</source>
        <translation>探索範囲の終点 %1</translation>
    </message>
    <message>
        <source>Where the volume of interest begins, in meters; targets are searched for in it alone</source>
        <translation>探索範囲の始点（メートル）。ターゲットはこの中だけで探します</translation>
    </message>
    <message>
        <source>Where the volume of interest ends, in meters; targets are searched for in it alone</source>
        <translation>探索範囲の終点（メートル）。ターゲットはこの中だけで探します</translation>
    </message>
    <message>
        <source>From the cameras</source>
        <translation>カメラから</translation>
    </message>
    <message>
        <source>Search for targets in the box around what at least two cameras see</source>
        <translation>少なくとも二台のカメラに写る範囲を囲む箱の中でターゲットを探します</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Search for targets anywhere</source>
        <translation>ターゲットをあらゆる場所で探します</translation>
    </message>
    <message>
        <source>Set volume of interest</source>
        <translation>探索範囲を設定</translation>
    </message>
    <message>
        <source>Remove volume of interest</source>
        <translation>探索範囲を解除</translation>
    </message>
    <message>
        <source>Targets are searched for in this box alone.</source>
        <translation>ターゲットはこの箱の中だけで探します。</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. The numbers are what the cameras see; change one to search in a box.</source>
        <translation>なし：ターゲットはあらゆる場所で探します。数値はカメラに写る範囲です。変更すると箱の中で探します。</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. Change a number to search in a box.</source>
        <translation>なし：ターゲットはあらゆる場所で探します。数値を変更すると箱の中で探します。</translation>
    </message>
    <message>
        <source>Change volume of interest</source>
        <translation>探索範囲を変更</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrationPage</name>
    <message>
        <source>Nudge the cameras by hand until they are roughly right. Then wave the ball, or a stick with two balls, through the whole volume, and refine.</source>
        <translation>まず手作業でカメラをおおよそ合わせます。次にボール、または2つのボールの付いた棒を空間全体で振り、精密化します。</translation>
    </message>
    <message>
        <source>Nudge the cameras by hand until they are roughly right. A recording of a ball, or a stick with two balls, waved through the whole volume then makes them exact.</source>
        <translation>まず手作業でカメラをおおよそ合わせます。ボール、または2つのボールの付いた棒を空間全体で振った録画から、正確に求められます。</translation>
    </message>
    <message>
        <source>Where the floor is</source>
        <translation>床の位置</translation>
    </message>
    <message>
        <source>Waving</source>
        <translation>振る</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>精密化</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>振る</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrator</name>
    <message>
        <source>Press Start waving, and wave for half a minute where things are to be tracked.</source>
        <translation>「振り始める」を押し、追跡する場所で30秒ほど振ってください。</translation>
    </message>
    <message>
        <source>Refine cameras with a waved stick</source>
        <translation>振った棒でカメラを精密化</translation>
    </message>
    <message>
        <source>Refine cameras with a waved ball</source>
        <translation>振ったボールでカメラを精密化</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandForm</name>
    <message>
        <source>the ball&apos;s diameter</source>
        <translation>ボールの直径</translation>
    </message>
    <message>
        <source>the ball&apos;s diameter, %1</source>
        <translation>ボールの直径 %1</translation>
    </message>
    <message>
        <source>the cameras as they are</source>
        <translation>今のカメラのまま</translation>
    </message>
    <message>
        <source>a distance touched</source>
        <translation>触れた2点の距離</translation>
    </message>
    <message>
        <source>Waved</source>
        <translation>振るもの</translation>
    </message>
    <message>
        <source>one ball</source>
        <translation>1つのボール</translation>
    </message>
    <message>
        <source>a stick with two balls</source>
        <translation>2つのボールの付いた棒</translation>
    </message>
    <message>
        <source>What is waved</source>
        <translation>何を振るか</translation>
    </message>
    <message>
        <source>A stick also gives the size, better than anything else</source>
        <translation>棒は大きさも与え、ほかの何よりも正確です</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>ボール</translation>
    </message>
    <message>
        <source>The target that is waved: its color is looked for</source>
        <translation>振るターゲット。その色を探します</translation>
    </message>
    <message>
        <source>Second ball</source>
        <translation>2つ目のボール</translation>
    </message>
    <message>
        <source>The target at the other end of the stick</source>
        <translation>棒のもう一方の端のターゲット</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Length of the stick</source>
        <translation>棒の長さ</translation>
    </message>
    <message>
        <source>From the middle of one ball to that of the other</source>
        <translation>一方のボールの中心からもう一方の中心まで</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Size from</source>
        <translation>大きさの基準</translation>
    </message>
    <message>
        <source>What gives the size</source>
        <translation>大きさを与えるもの</translation>
    </message>
    <message>
        <source>Images alone do not tell a large room from a small one: a diameter is good to about one percent, a distance to what you measure</source>
        <translation>画像だけでは大きな部屋と小さな部屋を区別できません。直径なら約1パーセント、距離なら測定の精度です</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Distance touched</source>
        <translation>触れた距離</translation>
    </message>
    <message>
        <source>Between the two places that the middle of the ball was held at</source>
        <translation>ボールの中心を置いた2か所の間</translation>
    </message>
    <message>
        <source>Off by up to</source>
        <translation>ずれの上限</translation>
    </message>
    <message>
        <source>How far cameras may be off</source>
        <translation>カメラの位置のずれ</translation>
    </message>
    <message>
        <source>How well the cameras are nudged: about how far each may be from its true place</source>
        <translation>カメラがどれだけ合わせてあるか。真の位置からのおおよその距離</translation>
    </message>
    <message>
        <source>How much cameras may be turned</source>
        <translation>カメラの向きのずれ</translation>
    </message>
    <message>
        <source>About how far each may be turned from where it truly looks</source>
        <translation>真の向きからのおおよその角度</translation>
    </message>
    <message>
        <source>Find time offsets</source>
        <translation>時間のずれを求める</translation>
    </message>
    <message>
        <source>For cameras that do not take their images at the same instants</source>
        <translation>同じ瞬間に撮影しないカメラのために</translation>
    </message>
    <message>
        <source>Find focal lengths</source>
        <translation>焦点距離を求める</translation>
    </message>
    <message>
        <source>For lenses that were never calibrated, or zoomed</source>
        <translation>較正していない、またはズームしたレンズのために</translation>
    </message>
    <message>
        <source>Find the distortion k1</source>
        <translation>歪み k1 を求める</translation>
    </message>
    <message>
        <source>The first coefficient of each lens; needs a ball seen up to the edges of the images</source>
        <translation>各レンズの第1係数。画像の端までボールが見えている必要があります</translation>
    </message>
    <message>
        <source>Only the selected span</source>
        <translation>選択した区間だけ</translation>
    </message>
    <message>
        <source>Look through the stretch selected in the timeline, not the whole recording</source>
        <translation>録画全体ではなく、タイムラインで選択した区間を調べる</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandOutcome</name>
    <message>
        <source>Refine cameras</source>
        <translation>カメラを精密化</translation>
    </message>
    <message>
        <source>Find the ball in all images, and the cameras that explain them best</source>
        <translation>すべての画像でボールを見つけ、それを最もよく説明するカメラを求める</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop; the cameras stay as they are</source>
        <translation>中止。カメラはそのままです</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>前の状態</translation>
    </message>
    <message>
        <source>While it is pressed, the grid is drawn with the cameras as they were</source>
        <translation>押している間、以前のカメラで格子を描く</translation>
    </message>
    <message>
        <source>Use it anyway</source>
        <translation>それでも使う</translation>
    </message>
    <message>
        <source>Take these cameras although something seems to be wrong; it can be undone</source>
        <translation>問題がありそうでもこのカメラを使う。元に戻せます</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>レポートを保存…</translation>
    </message>
    <message>
        <source>A page with all figures, residuals as arrows, coverage and a drawing in space</source>
        <translation>すべての数値、残差の矢印、網羅範囲、空間の図を含むページ</translation>
    </message>
    <message>
        <source>Cameras found</source>
        <translation>求めたカメラ</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>moved cm</source>
        <translation>移動 cm</translation>
    </message>
    <message>
        <source>turned °</source>
        <translation>回転 °</translation>
    </message>
    <message>
        <source>late ms</source>
        <translation>遅れ ms</translation>
    </message>
    <message>
        <source>Root mean square distance between seen and projected balls</source>
        <translation>検出と投影のボールの距離の二乗平均平方根</translation>
    </message>
    <message>
        <source>How far the camera is from where it was</source>
        <translation>元の位置からのカメラの距離</translation>
    </message>
    <message>
        <source>How far it is turned from where it looked</source>
        <translation>元の向きからの回転</translation>
    </message>
    <message>
        <source>The cameras are as they were.</source>
        <translation>カメラは元のままです。</translation>
    </message>
    <message>
        <source>Solutions without a part of the recording differ %1 times more than noise explains; the verdict includes that.</source>
        <translation>録画の一部を除いた解の違いは、雑音で説明できる大きさの %1 倍です。判定にはそれが含まれています。</translation>
    </message>
    <message>
        <source>The fall says %1 m/s² (9.81 is expected).</source>
        <translation>落下からは %1 m/s²（期待値は 9.81）。</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>レポートを保存</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>ウェブページ (*.html)</translation>
    </message>
    <message>
        <source>What was found of each camera; point at a heading to see what it means</source>
        <translation>各カメラについて分かったこと。見出しを指すと意味が表示されます</translation>
    </message>
    <message>
        <source>The cameras were changed since; this is about how they were refined.</source>
        <translation>カメラはその後変更されています。これは調整直後の状態についてのものです。</translation>
    </message>
    <message>
        <source>By how much its images are later than the first camera&apos;s, beyond what was known</source>
        <translation>既知の値に加えて、最初のカメラより画像がどれだけ遅れているか</translation>
    </message>
    <message>
        <source>That is less sure than the cameras were (off by up to %1): wave through more of the volume.</source>
        <translation>以前のカメラ（ずれは最大 %1）より不確かです。もっと広い範囲で振ってください。</translation>
    </message>
    <message>
        <source>How late cameras are is kept in the project: images are put together by it from now on.</source>
        <translation>カメラの遅れはプロジェクトに記録され、以後の画像はそれに従って組み合わされます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandWaving</name>
    <message>
        <source>Collect where every camera sees the ball; beginning again forgets what was collected before</source>
        <translation>各カメラがボールを見る位置を集める。始め直すと前のものは消えます</translation>
    </message>
    <message>
        <source>■ Stop waving</source>
        <translation>■ 振り終える</translation>
    </message>
    <message>
        <source>● Start waving</source>
        <translation>● 振り始める</translation>
    </message>
    <message>
        <source>Stop waving</source>
        <translation>振り終える</translation>
    </message>
    <message>
        <source>Start waving</source>
        <translation>振り始める</translation>
    </message>
    <message>
        <source>Nothing collected yet.</source>
        <translation>まだ何も集めていません。</translation>
    </message>
    <message>
        <source>%1 collected.</source>
        <translation>%1間集めました。</translation>
    </message>
    <message>
        <source>Every camera saw enough: stop, or refine.</source>
        <translation>どのカメラも十分に見ました。終えるか、精密化してください。</translation>
    </message>
    <message>
        <source>Go on: each camera should see the ball 150 times, in half of its image.</source>
        <translation>続けてください。各カメラが画像の半分でボールを150回見る必要があります。</translation>
    </message>
    <message>
        <source>Image sets left out because they came too fast: %1.</source>
        <translation>速すぎて省かれた画像の組: %1。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WindowMenus</name>
    <message>
        <source>Cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Choose this camera</source>
        <translation>このカメラを選びます</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Choose this target</source>
        <translation>このターゲットを選びます</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>キャリブレーション(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>実行(&amp;R)</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>最近のプロジェクトを開く</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>表示パネル</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Show this view</source>
        <translation>このビューを表示します</translation>
    </message>
    <message>
        <source>Speak this language</source>
        <translation>この言語で表示します</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>システムに合わせる</translation>
    </message>
</context>
</TS>

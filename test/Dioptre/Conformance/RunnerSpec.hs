{-# LANGUAGE OverloadedStrings #-}

-- | The runner against ports that misbehave: shell scripts, of which the n-th case asks for the number n.
module Dioptre.Conformance.RunnerSpec
  ( spec,
  )
where

import Control.Concurrent (threadDelay)
import Data.Aeson (object, toJSON, (.=))
import Data.IORef (modifyIORef', newIORef, readIORef)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Conformance.Compare (Comparison (Exact))
import Dioptre.Conformance.Runner
import Dioptre.Conformance.Verdict
import System.Directory (doesFileExist)
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec (Spec, describe, expectationFailure, it, shouldBe, shouldReturn, shouldSatisfy)

spec :: Spec
spec = do
  describe "a port that keeps the protocol" $ do
    it "passes" $ verdictsOf 8 (answering "ok $id") `shouldReturn` replicate 8 Passed
    it "is asked who it is" $ do
      ran <- run 8 (answering "ok $id")
      (ranIntroduction ran, ranComplaints ran) `shouldBe` (Just (toJSON (0 :: Int)), (0, []))
    it "passes more cases than the window holds" $ verdictsOf 200 (answering "ok $id") `shouldReturn` replicate 200 Passed
    it "may answer in any order" $
      verdictsOf 8 "read l; echo '{\"id\":0,\"ok\":{}}'; for i in 1 2 3 4 5 6 7 8; do read l; done; for i in 8 3 1 2 7 6 5 4; do echo '{\"id\":'$i',\"ok\":'$i'}'; done" `shouldReturn` replicate 8 Passed
    it "fails where it is wrong, and nowhere else" $
      failures 8 (answering "if [ $id = 3 ]; then ok 0; else ok $id; fi") `shouldReturn` [(3, Different (toJSON (0 :: Int)) "$")]
    it "fails where it answers an error" $ failures 8 (answering "if [ $id = 3 ]; then echo '{\"id\":3,\"error\":\"hm\"}'; else ok $id; fi") `shouldReturn` [(3, Refused "hm")]
    it "may skip, which is neither success nor failure" $
      verdictsOf 3 (answering "if [ $id = 2 ]; then echo '{\"id\":2,\"skip\":\"later\"}'; else ok $id; fi") `shouldReturn` [Passed, NotImplemented "later", Passed]
    it "reports each verdict once" $ do
      counted <- newIORef (0 :: Int)
      _ <- withPort' (answering "if [ $id = 2 ]; then exit 1; fi; ok $id") $ \command arguments -> runCases quick (modifyIORef' counted (+ 1)) command arguments (cases 8)
      readIORef counted `shouldReturn` 8
  describe "a port that crashes" $ do
    it "fails the case that it crashes at, and is started again for the others" $
      failures 8 (answering "if [ $id = 4 ]; then echo boom >&2; exit 7; fi; ok $id") `shouldReturn` [(4, Unanswered (Ended 7 "boom\n"))]
    it "fails each case that it crashes at" $
      map fst <$> failures 8 (answering "if [ $id = 1 ] || [ $id = 8 ]; then kill -9 $$; fi; ok $id") `shouldReturn` [1, 8]
    it "tells the signal" $ failures 2 (answering "if [ $id = 2 ]; then kill -9 $$; fi; ok $id") `shouldReturn` [(2, Unanswered (Ended (-9) ""))]
    it "is not blamed on cases that were outstanding as well" $
      -- The first time it ends without an answer to any of eight; from then on only the fifth makes it end.
      map fst
        <$> failures
          8
          ("if [ ! -e \"$0.seen\" ]; then : > \"$0.seen\"; read l; echo '{\"id\":0,\"ok\":0}'; for i in 1 2 3 4 5 6 7 8; do read l; done; exit 1; fi; " <> answering "if [ $id = 5 ]; then exit 1; fi; ok $id")
        `shouldReturn` [5]
    it "is given up where it never answers" $ do
      ran <- run 8 "exit 3"
      map snd (ranVerdicts ran) `shouldBe` replicate 8 (Failed (Unanswered (GivenUp (Just (Ended 3 "")))))
    it "is given up after twenty cases" $ do
      failed <- failures 30 (answering "if [ $id -gt 2 ]; then exit 1; fi; ok $id")
      map fst failed `shouldBe` [3 .. 30]
      [n | (n, Unanswered (GivenUp _)) <- failed] `shouldBe` [23 .. 30]
  describe "a port that hangs" $ do
    it "fails the case that it hangs at" $ failures 8 (answering "if [ $id = 4 ]; then sleep 100; fi; ok $id") `shouldReturn` [(4, Unanswered (Silent 0.5))]
    it "is killed with all that it started" . withSystemTempDirectory "port" $ \folder -> do
      let file = folder </> "late"
      failed <- failures 1 ("(sleep 2; : > " <> Text.pack file <> ") & wait")
      length failed `shouldBe` 1
      threadDelay 2500000
      doesFileExist file `shouldReturn` False
    it "fails where it does not end a line" $ map fst <$> failures 2 "while :; do printf xxxxxxxxxxxxxxxx; done" `shouldReturn` [1, 2]
    it "may be silent about who it is" $ do
      ran <- run 3 (answering "if [ $id != 0 ]; then ok $id; fi")
      (map snd (ranVerdicts ran), ranComplaints ran) `shouldBe` (replicate 3 Passed, (1, [NoIntroduction]))
    it "is told so where it goes on after its input has ended" $ do
      ran <- run 3 (answering "ok $id" <> "; sleep 100")
      (map snd (ranVerdicts ran), ranComplaints ran) `shouldBe` (replicate 3 Passed, (1, [DidNotEnd]))
  describe "a port that floods" $ do
    it "fails" $ do
      ran <- run 2 "while :; do echo nonsense; done"
      map snd (ranVerdicts ran) `shouldSatisfy` all isFailure
      fst (ranComplaints ran) `shouldSatisfy` (> 1000)
    it "fails the case that it answers with a line that is too long" $
      failures 3 (answering "if [ $id = 2 ]; then head -c 1100000 /dev/zero | tr '\\0' x; echo; fi; ok $id") `shouldReturn` [(2, Unanswered (LongLine 1048576))]
  describe "a port that answers nonsense" $ do
    it "fails the cases that it answers so" $
      failures 3 (answering "if [ $id = 3 ]; then echo hello; else ok $id; fi") `shouldReturn` [(3, Unanswered (Babbled "hello"))]
    it "fails the case that it cannot read" $
      failures 3 (answering "if [ $id = 2 ]; then echo '{\"error\":\"cannot read this\"}'; else ok $id; fi") `shouldReturn` [(2, Refused "cannot read this")]
    it "passes where it only chatters beside its answers" $ do
      ran <- run 3 (answering "echo working on it; ok $id")
      map snd (ranVerdicts ran) `shouldBe` replicate 3 Passed
      ranComplaints ran `shouldBe` (4, [NoAnswer "a line that is not JSON" "working on it"])
    it "passes where it answers what was not asked as well" $ do
      ran <- run 3 (answering "echo '{\"id\":99,\"ok\":1}'; ok $id; ok $id")
      map snd (ranVerdicts ran) `shouldBe` replicate 3 Passed
      fst (ranComplaints ran) `shouldSatisfy` (>= 7)
  it "tells that a program cannot be started" $ do
    ran <- runCases quick (pure ()) "./there-is-no-such-program" [] (cases 1)
    either (const True) (const False) ran `shouldBe` True

-- | A port that reads requests and does something for each, with its identifier in @id@; @ok@ answers that with a
-- number.
answering :: Text -> Text
answering each = "ok() { echo '{\"id\":'$id',\"ok\":'$1'}'; }; while read -r l; do id=${l#*:}; id=${id%%,*}; " <> each <> "; done"

quick :: Settings
quick = standardSettings {settingTimeout = 0.5}

cases :: Int -> [Case]
cases n =
  [ Case (Text.pack (show i)) "maths" "vector.modulus" ["vector.modulus.value"] "" [] (object ["a" .= [i, 0, 0]]) (toJSON i) Exact
    | i <- [1 .. n]
  ]

run :: Int -> Text -> IO Ran
run n script = withPort' script $ \command arguments ->
  runCases quick (pure ()) command arguments (cases n) >>= either (\fault -> expectationFailure (show fault) >> pure (Ran Nothing [] (0, []))) pure

-- | Gives the command of a script.
withPort' :: Text -> (FilePath -> [String] -> IO a) -> IO a
withPort' script use = withSystemTempDirectory "port" $ \folder -> do
  Text.writeFile (folder </> "port.sh") script
  use "sh" [folder </> "port.sh"]

verdictsOf :: Int -> Text -> IO [Verdict]
verdictsOf n script = map snd . ranVerdicts <$> run n script

-- | The numbers of the cases that failed, and why.
failures :: Int -> Text -> IO [(Int, Reason)]
failures n script = (\verdicts -> [(i, reason) | (i, Failed reason) <- zip [1 ..] verdicts]) <$> verdictsOf n script
